// What earlier clouds of a moving camera showed, and what messages tell, in the plans of both
// processes.
#include <algorithm>
#include <string>

#include "process/chain.hpp"
#include "process/encode_pose.hpp"
#include "process/planner/shown_table.hpp"
#include "process/scene_messages.hpp"
#include "quadrille/bus/encode.hpp"
#include "support/catch.hpp"
#include "support/depth_camera.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::encode_pose;

using test::kBack;
using test::kCautious;
using test::kFront;
using test::kUsPerSecond;
using test::refused_as;
using test::show_from;

/// The processes, of which the planner remembers nothing.
class Forgetful {
 public:
  Forgetful()
      : chain("--pose-channel POSE",
              kCautious + " --config " +
                  folder_.write("forgetful.toml", "[views]\nremember = 0.0\n")) {}

 private:
  const test::TempFolder folder_;

 public:
  Chain chain;
};

}  // namespace

TEST_CASE("what earlier clouds showed lets fewer grasps fail for unknown space",
          "[process][memory]") {
  Chain chain("--pose-channel POSE", kCautious);
  Forgetful forgetful;
  for (Chain* each : {&chain, &forgetful.chain}) show_from(*each, 1 * kUsPerSecond, kFront);
  CHECK(chain.bytes_of("GRASPS") == forgetful.chain.bytes_of("GRASPS"));
  for (Chain* each : {&chain, &forgetful.chain}) show_from(*each, 2 * kUsPerSecond, kBack);
  const grasps_t both = chain.grasps(), one = forgetful.chain.grasps();
  CAPTURE(both.grasps.size(), one.grasps.size());
  CHECK(refused_as(one, "unknown") > 20);
  CHECK(2 * refused_as(both, "unknown") < refused_as(one, "unknown"));
  CHECK_FALSE(both.grasps.empty());
}

TEST_CASE("a planner that is told to forget all plans as if it had just begun",
          "[process][memory][forget]") {
  Chain chain("--pose-channel POSE", kCautious), fresh("--pose-channel POSE", kCautious);
  show_from(chain, 1 * kUsPerSecond, kFront);
  show_from(chain, 2 * kUsPerSecond, kBack);
  const int remembered = refused_as(chain.grasps(), "unknown");
  chain.take("FORGET", test::forget_all_bytes());
  show_from(chain, 3 * kUsPerSecond, kBack);
  show_from(fresh, 3 * kUsPerSecond, kBack);
  CHECK(refused_as(chain.grasps(), "unknown") > remembered);
  // Tracks have another history.
  const auto poses = [](const grasps_t& grasps) {
    std::vector<double> numbers;
    for (const grasp_t& grasp : grasps.grasps) {
      numbers.insert(numbers.end(), grasp.pose.position, grasp.pose.position + 3);
      numbers.push_back(grasp.score);
    }
    return numbers;
  };
  CHECK(poses(chain.grasps()) == poses(fresh.grasps()));
}

TEST_CASE("a cloud that was taken before all was forgotten, and comes after, is not remembered",
          "[process][memory][forget]") {
  Chain chain("--pose-channel POSE", kCautious), untold("--pose-channel POSE", kCautious);
  forget_t forget{};
  forget.utime = 3 * kUsPerSecond / 2;
  forget.frame = "world";
  forget.all = 1;
  chain.take("FORGET", bus::encode(forget));
  for (Chain* each : {&chain, &untold}) {
    show_from(*each, 1 * kUsPerSecond, kFront);
    show_from(*each, 2 * kUsPerSecond, kBack);
  }
  CHECK(refused_as(chain.grasps(), "unknown") > refused_as(untold.grasps(), "unknown") + 10);
}

TEST_CASE("a region that is to be forgotten is unknown again, in whatever frame it is named",
          "[process][memory][forget]") {
  // The can, as the first cloud showed it from the other side, and the rays to it.
  const Eigen::Isometry3d X_WR =
      Eigen::Translation3d(0.0, 0.0, 0.06) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d size(0.5, 0.5, 0.3);
  const std::string frame = GENERATE("world", "camera", "eye", "");
  CAPTURE(frame);
  Chain chain("--pose-channel POSE", kCautious), untold("--pose-channel POSE", kCautious);
  for (Chain* each : {&chain, &untold}) show_from(*each, 1 * kUsPerSecond, kFront);
  // The camera's frame is that of the newest cloud.
  const Eigen::Isometry3d X_FW =
      frame == "world" ? Eigen::Isometry3d::Identity() : test::world_seen_from(kFront);
  chain.take("FORGET", test::forget_bytes(frame, X_FW * X_WR, size));
  for (Chain* each : {&chain, &untold}) show_from(*each, 2 * kUsPerSecond, kBack);
  CHECK(refused_as(chain.grasps(), "unknown") > refused_as(untold.grasps(), "unknown") + 10);
  // A region where nothing was seen changes nothing.
  Chain elsewhere("--pose-channel POSE", kCautious);
  show_from(elsewhere, 1 * kUsPerSecond, kFront);
  elsewhere.take("FORGET", test::forget_bytes("world", test::translation(0, 0, 5), size));
  show_from(elsewhere, 2 * kUsPerSecond, kBack);
  CHECK(elsewhere.bytes_of("GRASPS") == untold.bytes_of("GRASPS"));
}

TEST_CASE("a message to forget that makes no sense stops nothing",
          "[process][memory][forget][hostile]") {
  Chain chain("--pose-channel POSE", kCautious), untold("--pose-channel POSE", kCautious);
  const Eigen::Vector3d size(0.5, 0.5, 0.3);
  // Before the first cloud there is nothing to forget.
  chain.take("FORGET", test::forget_all_bytes());
  chain.take("FORGET", test::forget_bytes("camera", test::translation(0, 0, 0), size));
  for (Chain* each : {&chain, &untold}) show_from(*each, 1 * kUsPerSecond, kFront);
  chain.take("FORGET", test::forget_bytes("moon", test::translation(0, 0, 0), size));
  chain.take("FORGET", test::forget_bytes("world", test::translation(0, 0, 0), -size));
  chain.take("FORGET", {});
  for (Chain* each : {&chain, &untold}) show_from(*each, 2 * kUsPerSecond, kBack);
  CHECK(chain.bytes_of("GRASPS") == untold.bytes_of("GRASPS"));
}

TEST_CASE("the robot that a message tells is neither found nor in the way", "[process][robot]") {
  const Eigen::Isometry3d X_WFinger = test::translation(0.06, -0.07, 0.12);
  const Eigen::Vector3d size(0.02, 0.02, 0.16);
  const auto on_finger = [&](const Chain& chain) {
    const Eigen::Isometry3d X_WK = test::world_seen_from(kFront).inverse();
    const grasps_t grasps = chain.grasps();
    return std::count_if(grasps.grasps.begin(), grasps.grasps.end(), [&](const grasp_t& grasp) {
      return std::any_of(grasp.contacts, grasp.contacts + 2, [&](const double(&p)[3]) {
        const Eigen::Vector3d p_F =
            X_WFinger.inverse() * (X_WK * Eigen::Vector3d(p[0], p[1], p[2]));
        return (p_F.cwiseAbs().array() <= 0.5 * size.array() + 0.005).all();
      });
    });
  };
  const std::string options = "--pose-channel POSE", free = options + " --unknown free";
  Chain untold(options, free), told(options, free);
  show_from(untold, 1 * kUsPerSecond, kFront, true);
  told.take("ROBOT",
            test::robot_bytes(kUsPerSecond, "world", {test::box_message(X_WFinger, size)}));
  show_from(told, 1 * kUsPerSecond, kFront, true);
  CHECK(on_finger(told) == 0);
  CHECK(refused_as(told.grasps(), "collision") < refused_as(untold.grasps(), "collision"));
  CHECK_FALSE(told.grasps().grasps.empty());
}

TEST_CASE("nothing is found if the robot lies in a world of which no pose tells",
          "[process][robot]") {
  Chain chain("", "");
  chain.take("ROBOT", test::robot_bytes(kUsPerSecond, "world",
                                        {test::box_message(test::translation(0, 0, 1),
                                                           Eigen::Vector3d::Constant(0.1))}));
  show_from(chain, 1 * kUsPerSecond, kFront);
  CHECK(chain.quadrics().detections.empty());
  REQUIRE_FALSE(chain.quadrics().warnings.empty());
  CHECK(chain.quadrics().warnings[0].find("world") != std::string::npos);
}

TEST_CASE("nothing is planned if what is known lies in a frame that is not",
          "[process][knowledge]") {
  Chain chain("--pose-channel POSE", "--pose-channel POSE");
  chain.take("SUPPORT", test::support_bytes("moon", {0, 0, 1}, 0.0));
  show_from(chain, 1 * kUsPerSecond, kFront);
  CHECK(chain.grasps().grasps.empty());
  REQUIRE_FALSE(chain.grasps().warnings.empty());
  CHECK(chain.grasps().warnings[0].find("moon") != std::string::npos);
  chain.take("SUPPORT", test::support_bytes("world", {0, 0, 1}, 0.0));
  show_from(chain, 2 * kUsPerSecond, kFront);
  CHECK_FALSE(chain.grasps().grasps.empty());
}

}  // namespace quadrille
