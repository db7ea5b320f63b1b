#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "decode_checked.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kMaxNameBytes = 256;
/// Sizes of the fixed members of a quadric and of a dimension, with empty strings.
constexpr std::size_t kMinQuadricBytes = 229, kMinDimensionBytes = 21;

void check_finite(ByteReader& reader, const char* member, int count) {
  for (int i = 0; i < count; ++i) reader.read_finite(member);
}

void check_unit(ByteReader& reader, const char* member, int count) {
  double squared = 0.0;
  for (int i = 0; i < count; ++i) squared += std::pow(reader.read_finite(member), 2);
  if (!(std::abs(squared - 1.0) < 1e-6)) {
    refuse(RejectReason::kBadValue, std::string(member) + " is not of unit norm");
  }
}

void check_quadric(ByteReader& reader) {
  reader.read_int32("id");
  const std::string type = reader.read_string("type", kMaxNameBytes);
  if (!quadric_type_from_string(type)) {
    refuse(RejectReason::kBadValue, "a quadric of unknown type");
  }
  check_unit(reader, "q", 10);
  check_finite(reader, "score", 1);
  reader.read_int32("inliers");
  check_finite(reader, "rms", 1);
  check_finite(reader, "position", 3);
  check_unit(reader, "quaternion", 4);
  const std::int32_t dimensions = reader.read_count("num_dimensions", kMinDimensionBytes);
  for (std::int32_t i = 0; i < dimensions; ++i) {
    reader.read_string("dimension name", kMaxNameBytes);
    check_finite(reader, "dimension", 1);
    // A standard deviation that could not be estimated may be infinite or NaN.
    reader.read_double("std");
  }
  check_finite(reader, "extent", 6);
  check_finite(reader, "seen", 1);
  reader.read_int32("track");
}

void check_quadrics(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_int64("cloud_digest");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  reader.read_int64("points_read");
  reader.read_int64("points_finite");
  reader.read_int64("points_used");
  const std::int32_t detections = reader.read_count("num_detections", kMinQuadricBytes);
  if (static_cast<std::size_t>(detections) > kMaxQuadrics) {
    refuse(RejectReason::kTooLarge, std::to_string(detections) + " quadrics");
  }
  for (std::int32_t i = 0; i < detections; ++i) check_quadric(reader);
  const std::int32_t warnings = reader.read_count("num_warnings", kMinStringBytes);
  for (std::int32_t i = 0; i < warnings; ++i) reader.skip_string("warning");
}

Detection to_detection(const quadric_t& m) {
  Detection detection;
  detection.id = m.id;
  detection.type = quadric_type_from_string(m.type).value();
  detection.Q_C = Quadric(Vector10d(Eigen::Map<const Vector10d>(m.q)));
  detection.score = m.score;
  detection.inliers = m.inliers;
  detection.rms = m.rms;
  detection.X_CQ = from_message(m.pose);
  for (const dimension_t& d : m.dimensions)
    detection.dimensions.push_back({d.name, d.value, d.std});
  detection.extent_Q = Eigen::AlignedBox3d(Eigen::Vector3d(m.extent_min),  //
                                           Eigen::Vector3d(m.extent_max));
  detection.seen = m.seen;
  detection.track = m.track;
  return detection;
}

QuadricsMessage from_quadrics(quadrics_t m) {
  QuadricsMessage message{m.utime, m.seq,          std::move(m.frame),
                          {},      m.cloud_digest, std::move(m.warnings)};
  for (const quadric_t& quadric : m.detections) {
    message.detections.push_back(to_detection(quadric));
  }
  return message;
}

}  // namespace

Eigen::Isometry3d from_message(const pose_t& pose) {
  Eigen::Isometry3d X_CF = Eigen::Isometry3d::Identity();
  X_CF.translation() = Eigen::Vector3d(pose.position);
  X_CF.linear() = Eigen::Quaterniond(pose.quaternion[0], pose.quaternion[1], pose.quaternion[2],
                                     pose.quaternion[3])
                      .normalized()
                      .toRotationMatrix();
  return X_CF;
}

std::vector<Detection> as_received(const std::vector<Detection>& detections) {
  std::vector<Detection> received;
  received.reserve(detections.size());
  for (const Detection& detection : detections) {
    received.push_back(to_detection(to_message(detection)));
  }
  return received;
}

Decoded<QuadricsMessage> decode_quadrics(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<quadrics_t, QuadricsMessage>(bytes, max_bytes, check_quadrics,
                                                     from_quadrics);
}

}  // namespace quadrille::bus
