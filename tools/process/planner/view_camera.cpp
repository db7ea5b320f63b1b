#include "process/planner/view_camera.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>

#include "cli/frame_arguments.hpp"
#include "cli/process_arguments.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {

ViewCamera view_camera_of(const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos) {
    throw CLI::ValidationError(
        kViewCameraOption, fmt::format("'{}' names no poses; give CLOUDS=POSES, two channels, or "
                                       "CLOUDS=X,Y,Z,QW,QX,QY,QZ for a camera at rest",
                                       printable(text)));
  }
  if (mark == 0 || mark + 1 == text.size()) {
    throw CLI::ValidationError(
        kViewCameraOption,
        fmt::format("'{}' names no {}; give CLOUDS=POSES, with a channel or a pose after the =",
                    printable(text), mark == 0 ? "channel of clouds before the =" : "poses"));
  }
  ViewCamera camera{text.substr(0, mark), text.substr(mark + 1), {}};
  if (camera.pose_channel.find(',') != std::string::npos) {
    camera.X_WK = camera_pose_of(kViewCameraOption, camera.pose_channel);
    camera.pose_channel.clear();
  }
  check_channel(kViewCameraOption, camera.cloud_channel);
  if (!camera.X_WK) check_channel(kViewCameraOption, camera.pose_channel);
  return camera;
}

}  // namespace quadrille
