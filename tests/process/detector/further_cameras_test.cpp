// Further cameras that look at the scene of the detector's camera.
#include <CLI/CLI.hpp>
#include <string>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
#include "process/scene_messages.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

using test::Chain;
using test::kBack;
using test::kFront;
using test::kUsPerSecond;
using test::show_from;
using test::take_from;

const std::string kOne = "--pose-channel POSE", kTwo = kOne + " --view-camera SIDE=SIDE_POSE";

TEST_CASE("the detector finds with two cameras what one finds that was at both places",
          "[process][memory][cameras]") {
  // Tracks have another history, since they are those of the first camera.
  const test::TempFolder folder;
  const std::string config =
      " --config " + folder.write("untracked.toml", "[track]\nenabled = false\n");
  Chain one(kOne + config, kOne), two(kTwo + config, kOne);
  show_from(one, 1 * kUsPerSecond, kBack);
  take_from(two, "SIDE", "SIDE_POSE", 1 * kUsPerSecond, kBack);
  for (Chain* each : {&one, &two}) show_from(*each, 2 * kUsPerSecond, kFront);
  for (const char* channel : {"QUADRICS", "BOXES", "BODIES"}) {
    CHECK(one.bytes_of(channel) == two.bytes_of(channel));
  }
  CHECK_FALSE(two.quadrics().detections.empty());
  CHECK(two.detector_status().remembered_views == 2);
  // The second view has changed what is found.
  Chain alone(kOne + config, kOne);
  show_from(alone, 2 * kUsPerSecond, kFront);
  CHECK(alone.bytes_of("QUADRICS") != two.bytes_of("QUADRICS"));
}

TEST_CASE("the detector's status tells of its memory and of further cameras",
          "[process][memory][cameras]") {
  Chain chain(kTwo, kOne);
  chain.take("SIDE", {std::byte{1}, std::byte{2}});
  take_from(chain, "SIDE", "NOBODY", 1 * kUsPerSecond, kBack);
  chain.wait();
  CHECK(chain.detector_status().remembered_views == 0);
  take_from(chain, "SIDE", "SIDE_POSE", 2 * kUsPerSecond, kBack);
  show_from(chain, 2 * kUsPerSecond, kFront);
  const detector_status_t status = chain.detector_status();
  CHECK(status.decoded == 1);
  CHECK(status.decoded_views == 2);
  REQUIRE(status.num_rejected_views == 1);
  CHECK(status.rejected_views[0].name == "cut_short");
  REQUIRE(status.num_unplaced_views == 1);
  CHECK(status.unplaced_views[0].name == "no_pose");
  CHECK(status.remembered_views == 2);
  // The poses are exact, so what is left is noise.
  CHECK(status.pose_correction >= 0.0);
  CHECK(status.pose_correction < 0.003);
  CHECK(status.failed == 0);
  chain.take("FORGET", test::forget_all_bytes());
  CHECK(chain.detector_status().remembered_views == 0);
}

TEST_CASE("further cameras of the detector know the robot in the fixed frame alone",
          "[process][memory][cameras][robot]") {
  Chain chain(kTwo, kOne);
  const std::string frame = GENERATE("world", "camera");
  chain.take("ROBOT", test::robot_bytes(0, frame, {test::ball_message({0.0, 0.0, 1.0}, 0.05)}));
  take_from(chain, "SIDE", "SIDE_POSE", 2 * kUsPerSecond, kBack);
  const detector_status_t status = chain.detector_status();
  CHECK(status.failed == 0);
  CHECK(status.remembered_views == (frame == "world" ? 1 : 0));
  CHECK(status.num_rejected == (frame == "world" ? 0 : 1));
}

TEST_CASE("the detector refuses further cameras as the planner does",
          "[process][memory][cameras]") {
  const auto error = [](const std::string& arguments) {
    return test::error_of([&] { test::settings_from<DetectorCommandLine>(arguments); });
  };
  const test::TempFolder folder;
  CHECK(error("--view-camera SIDE=SIDE_POSE").find("needs the pose of the first camera") !=
        std::string::npos);
  CHECK(error(kTwo + " --config " + folder.write("forgetful.toml", "[views]\nremember = 0.0\n"))
            .find("set views.remember above 0") != std::string::npos);
  CHECK(error(kOne + " --view-camera SIDE").find("'SIDE' names no poses") != std::string::npos);
  CHECK(error(kOne + " --view-camera POSE=OTHER").find("'POSE' is the channel of") !=
        std::string::npos);
  CHECK(error(kTwo + " --in-channel CAM.*").find("a pattern stands for several cameras") !=
        std::string::npos);
}

}  // namespace
}  // namespace quadrille
