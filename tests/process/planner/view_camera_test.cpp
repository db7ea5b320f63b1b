// Further cameras that look at the scene of the first one.
#include "process/planner/view_camera.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
#include "process/scene_messages.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"

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
  Chain one("--pose-channel POSE", kCautious), two("--pose-channel POSE", kTwo);
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

TEST_CASE("a second camera may be at rest, and the first one too", "[process][memory][cameras]") {
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

TEST_CASE("options of further cameras that mean nothing are refused",
          "[process][memory][cameras]") {
  const auto error = [](const std::string& arguments) {
    return test::error_of(
        [&] { test::settings_from<PlannerCommandLine>(arguments + " --gripper franka"); });
  };
  const std::string posed = "--pose-channel POSE --view-camera ";
  CHECK(error("--view-camera SIDE=SIDE_POSE").find("needs the pose of the first camera") !=
        std::string::npos);
  CHECK(error(posed + "SIDE").find("'SIDE' names no poses") != std::string::npos);
  CHECK(error(posed + "SIDE=0,0,1,2,0,0,0").find("has norm 2") != std::string::npos);
  CHECK(error(posed + "SIDE=0,0,1").find("--view-camera") != std::string::npos);
  CHECK(error(posed + "=SIDE_POSE").find("--view-camera") != std::string::npos);
  CHECK(error(posed + "POSE=SIDE_POSE").find("'POSE' is the channel of") != std::string::npos);
  CHECK(error(posed + "SIDE=SIDE_POSE --view-camera SIDE=OTHER").find("'SIDE' is the channel of") !=
        std::string::npos);
}

}  // namespace
}  // namespace quadrille
