// Further cameras that look at the scene of the first one.
#include <string>
#include <vector>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
#include "process/scene_messages.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::kBack;
using test::kCautious;
using test::kFront;
using test::kUsPerSecond;
using test::refused_as;
using test::show_from;
using test::take_from;

const std::string kTwo = kCautious + " --view-camera SIDE=SIDE_POSE";

TEST_CASE("two cameras show as much as one that was at both places", "[process][memory][cameras]") {
  // The detector has one camera: without memory, both chains detect in the last cloud alone.
  const test::TempFolder folder;
  const std::string detector =
      "--pose-channel POSE --config " + folder.write("d.toml", "[views]\nremember = 0.0\n");
  Chain one(detector, kCautious), two(detector, kTwo);
  show_from(one, 1 * kUsPerSecond, kBack);
  take_from(two, "SIDE", "SIDE_POSE", 1 * kUsPerSecond, kBack);
  show_from(one, 2 * kUsPerSecond, kFront);
  show_from(two, 2 * kUsPerSecond, kFront);
  const grasps_t of_one = one.grasps(), of_two = two.grasps();
  REQUIRE(of_one.num_grasps > 0);
  REQUIRE(of_one.num_grasps == of_two.num_grasps);
  for (std::size_t n = 0; n < of_one.grasps.size(); ++n) {
    CHECK(of_one.grasps[n].score == of_two.grasps[n].score);
    for (int i = 0; i < 3; ++i) {
      CHECK(of_one.grasps[n].pose.position[i] == of_two.grasps[n].pose.position[i]);
    }
  }
}

TEST_CASE("clouds that two cameras took at one time both count", "[process][memory][cameras]") {
  Chain one("--pose-channel POSE", kCautious), two("--pose-channel POSE", kTwo);
  take_from(two, "SIDE", "SIDE_POSE", 2 * kUsPerSecond, kBack);
  show_from(one, 2 * kUsPerSecond, kFront);
  show_from(two, 2 * kUsPerSecond, kFront);
  const int unknown = refused_as(one.grasps(), "unknown");
  REQUIRE(unknown > 20);
  CHECK(2 * refused_as(two.grasps(), "unknown") < unknown);
}

TEST_CASE("a request on the same cloud knows what another camera has shown since",
          "[process][memory][cameras]") {
  Chain chain("--pose-channel POSE", kTwo);
  show_from(chain, 2 * kUsPerSecond, kFront);
  grasp_request_t request{};
  request.request_id = 7;
  const auto ask = [&] {
    chain.take("GRASP_REQUEST", bus::encode(request));
    REQUIRE(chain.grasps().request_id == 7);
    return refused_as(chain.grasps(), "unknown");
  };
  const int before = ask();
  REQUIRE(before > 20);
  take_from(chain, "SIDE", "SIDE_POSE", 2 * kUsPerSecond + 1000, kBack);
  CHECK(2 * ask() < before);
}

TEST_CASE("a region of another camera's frame that cannot be placed yet makes all be forgotten",
          "[process][memory][cameras]") {
  Chain chain("--pose-channel POSE", kTwo);
  take_from(chain, "SIDE", "SIDE_POSE", 1 * kUsPerSecond, kBack);
  REQUIRE(chain.planner_status().remembered_views == 1);
  forget_t region{};
  region.utime = 2 * kUsPerSecond;
  region.frame = "camera";
  region.region.quaternion[0] = 1.0;
  for (double& side : region.region_size) side = 0.1;
  chain.take("FORGET", bus::encode(region));
  CHECK(chain.planner_status().remembered_views == 0);
}

TEST_CASE("a second camera may be at rest", "[process][memory][cameras]") {
  const Eigen::Isometry3d X_WS = test::world_seen_from(kBack).inverse();
  const Eigen::Quaterniond q(X_WS.linear());
  const Eigen::Vector3d p = X_WS.translation();
  std::string pose;
  for (const double number : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()}) {
    pose += (pose.empty() ? "" : ",") + std::to_string(number);
  }
  Chain one("--pose-channel POSE", kCautious);
  Chain two("--pose-channel POSE", kCautious + " --view-camera SIDE=" + pose);
  take_from(two, "SIDE", "NOBODY", 1 * kUsPerSecond, kBack);
  show_from(one, 2 * kUsPerSecond, kFront);
  show_from(two, 2 * kUsPerSecond, kFront);
  CHECK(2 * refused_as(two.grasps(), "unknown") < refused_as(one.grasps(), "unknown"));
}

TEST_CASE("what a further camera saw without a pose, or before it was to be forgotten, is left out",
          "[process][memory][cameras]") {
  Chain one("--pose-channel POSE", kCautious), two("--pose-channel POSE", kTwo);
  if (GENERATE(true, false)) {
    take_from(two, "SIDE", "NOBODY", 1 * kUsPerSecond, kBack);
    two.wait();
  } else {
    take_from(two, "SIDE", "SIDE_POSE", 1 * kUsPerSecond, kBack);
    two.take("FORGET", test::forget_all_bytes());
  }
  show_from(one, 4 * kUsPerSecond, kFront);
  show_from(two, 4 * kUsPerSecond, kFront);
  CHECK(refused_as(one.grasps(), "unknown") == refused_as(two.grasps(), "unknown"));
}

}  // namespace
}  // namespace quadrille
