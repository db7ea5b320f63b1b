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

/// The quadrics of one cloud, as they came in a message.
struct QuadricsMessage {
  /// That of the cloud [us].
  std::int64_t utime = 0;
  /// That of the cloud; 0 where the cloud has none.
  std::int32_t seq = 0;
  /// Name of the cloud's frame C.
  std::string frame;
  std::vector<Detection> detections;
  /// digest_of() the cloud; 0: not known.
  std::int64_t cloud_digest = 0;
  /// What was odd about the cloud, a sentence each.
  std::vector<std::string> warnings = {};
};

/// Limits of what decode_quadrics() takes: ten times what is found in clouds of ten million points.
inline constexpr std::size_t kMaxQuadrics = 4096, kMaxQuadricsBytes = std::size_t{16} << 20;

/// The pose X_CF as a message.
QUADRILLE_EXPORT pose_t to_message(const Eigen::Isometry3d& X_CF);

/// The pose of a message; its quaternion must have unit norm.
QUADRILLE_EXPORT Eigen::Isometry3d from_message(const pose_t& pose);

/// One detection as a message; all in frame C.
QUADRILLE_EXPORT quadric_t to_message(const Detection& detection);

/// The result of detection as a message stamped with its cloud's utime, seq and frame.
QUADRILLE_EXPORT quadrics_t to_message(const CloudMessage& cloud, const DetectionResult& result);

/// The detections as whoever gets them in a message will have them: their poses pass through unit
/// quaternions, which rounds the last bits. What is computed from these is the same on both sides.
QUADRILLE_EXPORT std::vector<Detection> as_received(const std::vector<Detection>& detections);

/// Reads quadrics out of a message of type quadrille.quadrics_t, with every length, sign and value
/// checked before the generated decoder sees the bytes. More than kMaxQuadrics are refused.
/// @param bytes      the message as it came, fingerprint first
/// @param max_bytes  larger messages are refused [byte]
QUADRILLE_EXPORT Decoded<QuadricsMessage> decode_quadrics(
    std::span<const std::byte> bytes, std::size_t max_bytes = kMaxQuadricsBytes);

}  // namespace quadrille::bus
