#include "quadrille/bus/quadrics_message.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "messages/decode_checked.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kMaxNameBytes = 256;
/// Sizes of the fixed members of a quadric and of a dimension, with empty strings.
constexpr std::size_t kMinQuadricBytes = 229, kMinDimensionBytes = 21;

void check_quadric(ByteReader& reader) {
  reader.read_int32("id");
  const std::string type = reader.read_string("type", kMaxNameBytes);
  if (!quadric_type_from_string(type)) {
    refuse(RejectReason::kBadValue, "a quadric of unknown type");
  }
  reader.skip_unit("q", 10);
  reader.read_finite("score");
  reader.read_int32("inliers");
  reader.read_finite("rms");
  reader.skip_pose();
  reader.skip_list("dimensions", kMinDimensionBytes, [](ByteReader& dimension) {
    dimension.read_string("dimension name", kMaxNameBytes);
    dimension.read_finite("dimension");
    // A standard deviation that could not be estimated may be infinite or NaN.
    dimension.read_double("std");
  });
  reader.skip_finite("extent", 6);
  reader.read_finite("seen");
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
  reader.skip_strings("warnings");
}

void copy(const Eigen::Vector3d& from, double to[3]) { std::copy_n(from.data(), 3, to); }

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

pose_t to_message(const Eigen::Isometry3d& X_CF) {
  pose_t pose;
  copy(X_CF.translation(), pose.position);
  const Eigen::Quaterniond R_CF = rotation_of(X_CF);
  pose.quaternion[0] = R_CF.w();
  pose.quaternion[1] = R_CF.x();
  pose.quaternion[2] = R_CF.y();
  pose.quaternion[3] = R_CF.z();
  return pose;
}

quadric_t to_message(const Detection& detection) {
  quadric_t m;
  m.id = detection.id;
  m.type = to_string(detection.type);
  const Vector10d q = detection.Q_C.coefficients();
  std::copy_n(q.data(), 10, m.q);
  m.score = detection.score;
  m.inliers = detection.inliers;
  m.rms = detection.rms;
  m.pose = to_message(detection.X_CQ);
  for (const Dimension& dimension : detection.dimensions) {
    dimension_t d;
    d.name = dimension.name;
    d.value = dimension.value;
    d.std = dimension.std;
    m.dimensions.push_back(d);
  }
  m.num_dimensions = static_cast<std::int32_t>(m.dimensions.size());
  copy(detection.extent_Q.min(), m.extent_min);
  copy(detection.extent_Q.max(), m.extent_max);
  m.seen = detection.seen;
  m.track = detection.track;
  return m;
}

quadrics_t to_message(const CloudMessage& cloud, const DetectionResult& result) {
  quadrics_t m;
  m.utime = cloud.utime;
  m.cloud_digest = cloud.digest;
  m.seq = cloud.seq;
  m.frame = cloud.cloud.frame;
  m.points_read = static_cast<std::int64_t>(cloud.cloud.read);
  m.points_finite = static_cast<std::int64_t>(result.points_finite);
  m.points_used = static_cast<std::int64_t>(result.points_used);
  for (const Detection& detection : result.detections) {
    m.detections.push_back(to_message(detection));
  }
  m.num_detections = static_cast<std::int32_t>(m.detections.size());
  m.warnings = result.warnings;
  m.num_warnings = static_cast<std::int32_t>(m.warnings.size());
  return m;
}

Eigen::Isometry3d from_message(const pose_t& pose) {
  Eigen::Isometry3d X_CF = Eigen::Isometry3d::Identity();
  X_CF.translation() = Eigen::Vector3d(pose.position);
  X_CF.linear() = Eigen::Quaterniond(pose.quaternion[0], pose.quaternion[1], pose.quaternion[2],
                                     pose.quaternion[3])
                      .normalized()
                      .toRotationMatrix();
  return X_CF;
}

Decoded<QuadricsMessage> decode_quadrics(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<quadrics_t, QuadricsMessage>(bytes, max_bytes, check_quadrics,
                                                     from_quadrics);
}

}  // namespace quadrille::bus
