// Further cameras that look at the scene of the detector's camera.
#include <CLI/CLI.hpp>
#include <string>

#include "process/chain.hpp"
#include "process/planner/shown_table.hpp"
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
