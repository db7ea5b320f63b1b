#include "quadrille/bus/quadrics_message.hpp"

#include <algorithm>

namespace quadrille::bus {
namespace {

void copy(const Eigen::Vector3d& from, double to[3]) { std::copy_n(from.data(), 3, to); }

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

}  // namespace quadrille::bus
