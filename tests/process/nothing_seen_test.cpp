// Clouds that show nothing, while earlier ones are remembered.
#include <algorithm>
#include <limits>
#include <string>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::kFront;
using test::kUsPerSecond;
using test::show_from;

const std::string kPosed = "--pose-channel POSE";

/// A cloud without a point, or one whose points are all missing.
std::vector<std::byte> blind_cloud(std::int64_t utime, bool empty) {
  bus::CloudMessage message{utime, 0, {}};
  message.cloud.frame = "eye";
  if (!empty) {
    message.cloud.width = 160;
    message.cloud.height = 120;
    message.cloud.read = 160 * 120;
    message.cloud.points.assign(message.cloud.read,
                                Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  }
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

/// The camera stands still and sees nothing.
void show_nothing(Chain& chain, std::int64_t utime, bool empty, bool with_pose = true) {
  if (with_pose) {
    chain.take("POSE", test::encode_pose(utime, test::world_seen_from(kFront).inverse()));
  }
  chain.take("POINT_CLOUD", blind_cloud(utime, empty));
  chain.wait();
  REQUIRE(chain.quadrics().utime == utime);
  REQUIRE(chain.grasps().utime == utime);
}

std::vector<SceneBody> bodies_of(const Chain& chain) {
  return std::get<bus::BodiesMessage>(bus::decode_bodies(chain.bytes_of("BODIES"))).bodies;
}

TEST_CASE("what is remembered is published when a cloud shows nothing, and can be grasped",
          "[process][memory]") {
  const bool empty = GENERATE(true, false);
  CAPTURE(empty);
  Chain chain(kPosed, kPosed);
  show_from(chain, 1 * kUsPerSecond, kFront);
  const auto before = chain.quadrics().detections;
  REQUIRE(bodies_of(chain).size() == 2);
  REQUIRE_FALSE(chain.grasps().grasps.empty());
  show_nothing(chain, 3 * kUsPerSecond, empty);
  const auto after = chain.quadrics();
  REQUIRE(after.detections.size() == before.size());
  for (const Detection& d : before) {
    // Scores differ a little without the points, and so may the order.
    const auto same = std::find_if(after.detections.begin(), after.detections.end(),
                                   [&](const Detection& other) { return other.track == d.track; });
    REQUIRE(same != after.detections.end());
    CHECK(same->type == d.type);
    CHECK((same->X_CQ.translation() - d.X_CQ.translation()).norm() < 0.002);
  }
  REQUIRE(bodies_of(chain).size() == 2);
  for (const SceneBody& body : bodies_of(chain)) {
    CHECK(body.views == 1);
    CHECK(body.unseen == Approx(2.0));
  }
  REQUIRE_FALSE(after.warnings.empty());
  CHECK(after.warnings.front() ==
        "this cloud shows nothing: the result is what 1 other cloud showed, 2.00 s before");
  CHECK_FALSE(chain.grasps().grasps.empty());
  bool said = false;
  for (const std::string& warning : chain.grasps().warnings) {
    said = said || warning.find("the plan is on what the further views show") != std::string::npos;
  }
  CHECK(said);
  CHECK(chain.detector_status().remembered_views == 1);
  CHECK(chain.planner_status().remembered_views == 1);
}

TEST_CASE("what is remembered is gone after its time, though no cloud shows anything since",
          "[process][memory]") {
  Chain chain(kPosed, kPosed);
  show_from(chain, 1 * kUsPerSecond, kFront);
  show_nothing(chain, 62 * kUsPerSecond, true);
  CHECK(chain.quadrics().detections.empty());
  CHECK(chain.grasps().grasps.empty());
  CHECK(chain.detector_status().remembered_views == 0);
  CHECK(chain.planner_status().remembered_views == 0);
}

TEST_CASE("a cloud without a pose does not show what is remembered", "[process][memory]") {
  Chain chain(kPosed, kPosed);
  show_from(chain, 1 * kUsPerSecond, kFront);
  show_nothing(chain, 3 * kUsPerSecond, true, false);
  CHECK(chain.quadrics().detections.empty());
  CHECK(chain.grasps().grasps.empty());
  CHECK(chain.detector_status().remembered_views == 1);
}

}  // namespace
}  // namespace quadrille
