#include "view/live/scene_frames.hpp"

namespace quadrille::view {

std::optional<Eigen::Isometry3d> SceneFrames::camera_in(const std::string& frame) const {
  const bool is_world = frame == kWorldFrame || (frame == cloud && cloud_in_world);
  if (is_world) return X_WK;
  if (frame == kCameraFrame || frame == cloud) return Eigen::Isometry3d::Identity();
  return std::nullopt;
}

std::optional<Eigen::Isometry3d> SceneFrames::X_SF(const std::string& frame) const {
  if (frame.empty() || frame == scene) return Eigen::Isometry3d::Identity();
  const auto X_SK = camera_in(scene), X_FK = camera_in(frame);
  if (!X_SK || !X_FK) return std::nullopt;
  return *X_SK * X_FK->inverse();
}

}  // namespace quadrille::view
