#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace quadrille::view {

/// Names of the camera's frame K and of the fixed frame W in messages.
inline constexpr const char* kCameraFrame = "camera";
inline constexpr const char* kWorldFrame = "world";

/// The frames that messages name, at the time of the cloud that is shown.
struct SceneFrames {
  /// Names of the frame S of the scene, which is that of the results, and of the cloud's frame.
  std::string scene, cloud;
  /// True if the cloud is in W; else it is in K.
  bool cloud_in_world = false;
  /// Pose of the camera in W, if it is known.
  std::optional<Eigen::Isometry3d> X_WK;

  /// Returns the pose of K in the scene's frame; nullopt if it is not known.
  std::optional<Eigen::Isometry3d> X_SK() const { return camera_in(scene); }
  /// Returns the pose in S of the frame that a message names: "camera", "world", the name of the
  /// cloud's frame, or "" for that of the scene; nullopt if it is not known.
  std::optional<Eigen::Isometry3d> X_SF(const std::string& frame) const;

 private:
  std::optional<Eigen::Isometry3d> camera_in(const std::string& frame) const;
};

}  // namespace quadrille::view
