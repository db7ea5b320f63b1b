#include <Eigen/QR>
#include <utility>

#include "quadrille/detector/detection.hpp"

namespace quadrille {
namespace {

/// The linear map of quadric coefficients that takes f(x) to f(X⁻¹ x).
Eigen::Matrix<double, 10, 10> coefficients_map(const Eigen::Isometry3d& X_FC) {
  Eigen::Matrix<double, 10, 10> map;
  for (int k = 0; k < 10; ++k) {
    map.col(k) = Quadric(Vector10d(Vector10d::Unit(k))).transformed(X_FC).coefficients();
  }
  return map;
}

/// The covariance of a unit q after a linear map and renormalisation to a unit vector.
QuadricCovariance mapped(const QuadricCovariance& covariance,
                         const Eigen::Matrix<double, 10, 10>& map, const Vector10d& q) {
  const Vector10d there = (map * q).normalized();
  const Eigen::Matrix<double, 10, 10> turn =
      (map - there * (there.transpose() * map)) / (map * q).norm();
  QuadricCovariance result;
  result.known = turn * covariance.known * turn.transpose();
  if (covariance.open.cols() == 0) return result;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(turn * covariance.open);
  result.open = qr.householderQ() * Eigen::MatrixXd::Identity(10, covariance.open.cols());
  return result;
}

}  // namespace

PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return cloud;
  for (Eigen::Vector3f& p : cloud.points) p = (X_FC * p.cast<double>()).cast<float>();
  cloud.viewpoint = X_FC * cloud.viewpoint;
  return cloud;
}

Detection moved(Detection detection, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return detection;
  detection.covariance =
      mapped(detection.covariance, coefficients_map(X_FC), detection.Q_C.coefficients());
  detection.Q_C = Quadric(detection.Q_C.transformed(X_FC).normalized().coefficients());
  detection.X_CQ = rounded(X_FC * detection.X_CQ);
  return detection;
}

std::vector<Detection> moved(std::vector<Detection> detections, const Eigen::Isometry3d& X_FC) {
  for (Detection& d : detections) d = moved(std::move(d), X_FC);
  return detections;
}

std::vector<Box> moved(std::vector<Box> boxes, const Eigen::Isometry3d& X_FC) {
  if (X_FC.matrix().isIdentity(0.0)) return boxes;
  for (Box& box : boxes) box.X_CB = rounded(X_FC * box.X_CB);
  return boxes;
}

}  // namespace quadrille
