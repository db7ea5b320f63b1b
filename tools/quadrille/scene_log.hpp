#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lab/scene/pose_error.hpp"
#include "lab/scene/scene.hpp"
#include "quadrille/grasping/gripper.hpp"

namespace quadrille {

/// The options of a log of a camera that moves about a scene.
struct SceneLogOptions {
  scene::SceneOptions scene;
  /// Number of clouds, at least 2; 0 if no log is wanted.
  int clouds = 0;
  /// Clouds per second.
  double rate = 30.0;
  /// Error of the poses.
  scene::PoseErrorSize pose_error;
  /// The hand that the camera has in its pictures; nullopt for none.
  std::optional<Gripper> hand;
};

/// What a log of a scene holds.
struct SceneLogSummary {
  int quadrics = 0;
  /// Bytes of all messages.
  std::int64_t bytes = 0;
};

/// Channels of the clouds, of the camera's poses and of the hand's shapes.
inline constexpr const char *kCloudChannel = "POINT_CLOUD", *kCameraChannel = "CAMERA_POSE",
                            *kHandChannel = "ROBOT";

/// Writes the pictures of a camera that moves along a scene::CameraPath, with the camera's poses,
/// as an LCM log, and the truth beside it. The fixed frame W of the poses, and of the truth, is the
/// camera's frame in the first picture. The hand is no part of the truth; its shapes are told
/// before each cloud. The same options give the same bytes.
/// @param path  the log (.lcm)
/// @throws std::runtime_error if a file cannot be written
SceneLogSummary write_scene_log(const std::string& path, const SceneLogOptions& options);

}  // namespace quadrille
