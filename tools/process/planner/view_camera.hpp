#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace quadrille {

/// The option that names one.
inline constexpr const char* kViewCameraOption = "--view-camera";

/// One more camera that looks at the scene. What its clouds show serves the plans on the clouds of
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

}  // namespace quadrille
