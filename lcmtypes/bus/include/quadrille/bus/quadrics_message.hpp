#pragma once

#include <cstddef>
#include <cstdint>
#include <lcmtypes/quadrille/pose_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <span>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/rejection.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

/// The quadrics of one cloud, as received in a message.
struct QuadricsMessage {
  /// Time of the cloud [us].
  std::int64_t utime = 0;
  /// Number of the cloud; 0 if the cloud has none.
  std::int32_t seq = 0;
  /// Name of the cloud's frame C.
  std::string frame;
  std::vector<Detection> detections;
  /// Result of digest_of() for the cloud; 0 if not known.
  std::int64_t cloud_digest = 0;
  /// Warnings about the cloud, one sentence each.
  std::vector<std::string> warnings = {};
};

/// Limits of decode_quadrics(): ten times what is found in clouds of ten million points.
inline constexpr std::size_t kMaxQuadrics = 4096, kMaxQuadricsBytes = std::size_t{16} << 20;

/// Makes the message of the pose X_CF.
QUADRILLE_EXPORT pose_t to_message(const Eigen::Isometry3d& X_CF);

/// Reads the pose of a message, whose quaternion must have unit norm.
QUADRILLE_EXPORT Eigen::Isometry3d from_message(const pose_t& pose);

/// Makes the message of one detection, in frame C; its field `pose` is X_CQ.
QUADRILLE_EXPORT quadric_t to_message(const Detection& detection);

/// Makes the message of a detection result, stamped with its cloud's utime, seq and frame.
QUADRILLE_EXPORT quadrics_t to_message(const CloudMessage& cloud, const DetectionResult& result);

/// Reads quadrics from a message of type quadrille.quadrics_t. Every length, sign and value is
/// checked before the generated decoder sees the bytes. More than kMaxQuadrics are refused.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<QuadricsMessage> decode_quadrics(
    std::span<const std::byte> bytes, std::size_t max_bytes = kMaxQuadricsBytes);

}  // namespace quadrille::bus
