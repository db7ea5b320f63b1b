#pragma once

#include <Eigen/Eigenvalues>

namespace quadrille {

/// Unit direction of least spread of points with this covariance.
inline Eigen::Vector3d min_spread_direction(const Eigen::Matrix3d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  return eigen.computeDirect(covariance).eigenvectors().col(0);
}

/// Sums over positions for the plane through them by total least squares, in double precision, for
/// regions of any size. PlaneMoments is the faster version for a few points around another.
struct PlaneSums {
  double n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  /// Only the lower triangle is used.
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& x) {
    n += 1;
    sum += x;
    square(0, 0) += x[0] * x[0];
    square(1, 0) += x[1] * x[0];
    square(2, 0) += x[2] * x[0];
    square(1, 1) += x[1] * x[1];
    square(2, 1) += x[2] * x[1];
    square(2, 2) += x[2] * x[2];
  }

  /// Returns (n, d) of the plane n·x + d = 0, where n has unit length and either sign. There must
  /// be at least three points.
  Eigen::Vector4d plane() const {
    const Eigen::Vector3d mean = sum / n;
    const Eigen::Vector3d m = min_spread_direction(squares() / n - mean * mean.transpose());
    return {m.x(), m.y(), m.z(), -m.dot(mean)};
  }
  /// Returns the sum of x xᵀ.
  Eigen::Matrix3d squares() const { return square.selfadjointView<Eigen::Lower>(); }
};

}  // namespace quadrille
