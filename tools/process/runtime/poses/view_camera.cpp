#include "process/runtime/poses/view_camera.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>

#include "cli/frame_arguments.hpp"
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

void add_view_camera_option(CLI::App& app, std::vector<ViewCamera>& cameras) {
  app.add_option_function<std::vector<std::string>>(
         kViewCameraOption,
         [&cameras](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) cameras.push_back(view_camera_of(text));
         },
         "Clouds of one more camera that looks at the scene, and its poses or, at rest, its pose "
         "in the fixed frame; may be repeated")
      ->type_name("CLOUDS=POSES")
      ->allow_extra_args(false)
      ->expected(1, ViewCamera::kMost);
}

void check_view_cameras(const std::vector<ViewCamera>& cameras, bool has_fixed_frame,
                        const ViewOptions& views) {
  if (cameras.empty()) return;
  if (!has_fixed_frame) {
    throw CLI::ValidationError(
        kViewCameraOption,
        "needs the pose of the first camera too; give --pose-channel or --camera-pose");
  }
  if (views.remember == 0.0) {
    throw CLI::ValidationError(kViewCameraOption,
                               "is of no use without memory; set views.remember above 0");
  }
  const int all = static_cast<int>(cameras.size()) + 1;
  if (all > views.most) {
    throw CLI::ValidationError(
        kViewCameraOption,
        fmt::format("{} cameras need as many views in memory, or each drives out another; set "
                    "views.most to {} at least (it is {})",
                    all, all, views.most));
  }
}

}  // namespace quadrille
