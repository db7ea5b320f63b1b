#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace quadrille {

/// Poses of a cloud and of its results; the work is done in frame K, the camera's.
struct Placement {
  /// Pose of frame K in the cloud's frame C and in the frame R of the results.
  Eigen::Isometry3d X_CK = Eigen::Isometry3d::Identity(), X_RK = Eigen::Isometry3d::Identity();
  /// Pose of frame K in the fixed frame, if the camera's pose is known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Name of R if it differs from C; otherwise empty.
  std::string frame;
  /// Why the camera's pose, although needed, is not known; empty if nothing is missing.
  std::string lack;

  /// Returns the name of the frame of the results.
  /// @param cloud_frame  name of C
  const std::string& frame_of_results(const std::string& cloud_frame) const {
    return frame.empty() ? cloud_frame : frame;
  }
};

/// Returns the pose of frame K, the camera's when it took a cloud, in the frame that a message
/// names: "camera", "world", the name of the cloud's frame, or "" for the frame of the results.
/// @param cloud_frame  name of the cloud's frame
/// @throws std::invalid_argument if the frame or the pose is not known; the message says which
Eigen::Isometry3d pose_of_camera(const std::string& frame, const Placement& placement,
                                 const std::string& cloud_frame);

}  // namespace quadrille
