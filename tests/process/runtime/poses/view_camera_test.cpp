#include "process/runtime/poses/view_camera.hpp"

#include <string>

#include "process/chain.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

TEST_CASE("options of further cameras that mean nothing are refused",
          "[process][memory][cameras]") {
  const auto error = [](const std::string& arguments) {
    return test::error_of(
        [&] { test::settings_from<PlannerCommandLine>(arguments + " --gripper franka"); });
  };
  const std::string posed = "--pose-channel POSE --view-camera ";
  CHECK(error("--view-camera SIDE=SIDE_POSE").find("needs the pose of the first camera") !=
        std::string::npos);
  std::string many = "--pose-channel POSE";
  for (int n = 0; n < 16; ++n) {
    many += " --view-camera C" + std::to_string(n) + "=P" + std::to_string(n);
  }
  CHECK(error(many).find("--view-camera") != std::string::npos);
  // The memory must have room for one view of each camera.
  std::string eight;
  for (int n = 0; n < 8; ++n) {
    eight += " --view-camera C" + std::to_string(n) + "=P" + std::to_string(n);
  }
  CHECK(error("--pose-channel POSE" + eight).find("set views.most to 9 at least (it is 8)") !=
        std::string::npos);
  const test::TempFolder folder;
  CHECK(error(posed + "SIDE=SIDE_POSE --config " +
              folder.write("forgetful.toml", "[views]\nremember = 0.0\n"))
            .find("set views.remember above 0") != std::string::npos);
  CHECK(error(posed + "SIDE").find("'SIDE' names no poses") != std::string::npos);
  CHECK(error(posed + "SIDE=").find("'SIDE=' names no poses; give") != std::string::npos);
  CHECK(error(posed + "=SIDE_POSE").find("'=SIDE_POSE' names no channel of clouds before the =") !=
        std::string::npos);
  CHECK(error(posed + "SIDE=0,0,1,2,0,0,0").find("has norm 2") != std::string::npos);
  CHECK(error(posed + "SIDE=0,0,1").find("--view-camera") != std::string::npos);
  CHECK(error(posed + "=SIDE_POSE").find("--view-camera") != std::string::npos);
  CHECK(error(posed + "POSE=SIDE_POSE").find("'POSE' is the channel of") != std::string::npos);
  CHECK(error(posed + "SIDE=SIDE_POSE --view-camera SIDE=OTHER").find("'SIDE' is the channel of") !=
        std::string::npos);
}

}  // namespace
}  // namespace quadrille
