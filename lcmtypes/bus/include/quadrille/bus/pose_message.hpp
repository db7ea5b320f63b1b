#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The pose of a camera in a message.
struct PoseMessage {
  /// Time of the pose [us].
  std::int64_t utime = 0;
  /// Pose of the camera's frame in the fixed frame [m].
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
};

/// Reads a pose from a message of type bot_core.pose_t, with every value checked. Its quaternion
/// may deviate from unit norm by single-precision rounding, and is normalised.
/// @param bytes  the message as it came, fingerprint first
QUADRILLE_EXPORT Decoded<PoseMessage> decode_pose(std::span<const std::byte> bytes);

/// Returns the bytes of a pose as a message of type bot_core.pose_t, whose velocities, rates and
/// accelerations are 0.
QUADRILLE_EXPORT std::vector<std::byte> encode_pose(const PoseMessage& message);

}  // namespace quadrille::bus
