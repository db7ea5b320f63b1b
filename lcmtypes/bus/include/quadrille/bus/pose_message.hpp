#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// Where a camera was, as it came in a message.
struct PoseMessage {
  /// [us]
  std::int64_t utime = 0;
  /// Pose of the camera's frame in the fixed one [m].
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
};

/// Reads a pose out of a message of type bot_core.pose_t, with every value checked. Its quaternion
/// may miss unit norm by the rounding of single precision, and is brought to it.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<PoseMessage> decode_pose(std::span<const std::byte> bytes);

}  // namespace quadrille::bus
