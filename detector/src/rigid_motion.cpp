#include "quadrille/detector/rigid_motion.hpp"

#include <utility>

namespace quadrille {

PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return cloud;
  for (Eigen::Vector3f& p : cloud.points) p = (X_FC * p.cast<double>()).cast<float>();
  cloud.viewpoint = X_FC * cloud.viewpoint;
  return cloud;
}

Detection moved(Detection detection, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return detection;
  detection.Q_C = detection.Q_C.transformed(X_FC).normalized();
  detection.X_CQ = X_FC * detection.X_CQ;
  return detection;
}

std::vector<Detection> moved(std::vector<Detection> detections, const Eigen::Isometry3d& X_FC) {
  for (Detection& d : detections) d = moved(std::move(d), X_FC);
  return detections;
}

std::vector<Box> moved(std::vector<Box> boxes, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return boxes;
  for (Box& box : boxes) box.X_CB = X_FC * box.X_CB;
  return boxes;
}

}  // namespace quadrille
