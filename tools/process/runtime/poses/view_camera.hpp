#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "cli/process_arguments.hpp"
#include "quadrille/detector/options.hpp"

namespace CLI {
class App;
}

namespace quadrille {

/// The option that names one.
inline constexpr const char* kViewCameraOption = "--view-camera";

/// One more camera that looks at the scene. What its clouds show serves the work on the clouds of
/// the first camera.
struct ViewCamera {
  /// Largest number of them beside the first camera.
  static constexpr int kMost = 15;

  std::string cloud_channel;
  /// Channel of its poses in the fixed frame; empty if it is at rest.
  std::string pose_channel;
  /// Pose in W of a camera at rest.
  std::optional<Eigen::Isometry3d> X_WK;
};

/// Reads "CLOUDS=POSES", two channels, or "CLOUDS=X,Y,Z,QW,QX,QY,QZ", a channel and a pose.
/// @throws CLI::ValidationError naming --view-camera if the text is neither
ViewCamera view_camera_of(const std::string& text);

/// Adds --view-camera; the list must outlive the app.
void add_view_camera_option(CLI::App& app, std::vector<ViewCamera>& cameras);

/// Checks that further cameras, if there are any, are of use.
/// @param has_fixed_frame  true if the pose of the first camera is given, or comes
/// @param views            how many views are remembered, and how long
/// @throws CLI::ValidationError if they are not
void check_view_cameras(const std::vector<ViewCamera>& cameras, bool has_fixed_frame,
                        const ViewOptions& views);

/// Lists the channels of further cameras, as visit_channels() of the settings does.
template <class ViewCameras, class Visit>
void visit_view_cameras(ViewCameras& cameras, const Visit& visit) {
  for (auto& camera : cameras) {
    visit(Way::kIn, kViewCameraOption, camera.cloud_channel, "clouds of a further camera");
    if (camera.X_WK) continue;
    visit(Way::kIn, kViewCameraOption, camera.pose_channel, "poses of a further camera");
  }
}

}  // namespace quadrille
