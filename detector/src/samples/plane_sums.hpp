#pragma once

#include <Eigen/Eigenvalues>

namespace quadrille {

/// Unit direction in which points of a covariance are spread least.
inline Eigen::Vector3d min_spread_direction(const Eigen::Matrix3d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  return eigen.computeDirect(covariance).eigenvectors().col(0);
}

/// Sums over positions for the plane through them by total least squares, in double precision, for
/// regions of any size. PlaneMoments is the quick one for a few points about another.
struct PlaneSums {
  double n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  /// The lower triangle alone counts.
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

  /// (n, d) of the plane n·x + d = 0, n of unit length on either side. There must be three points.
  Eigen::Vector4d plane() const {
    const Eigen::Vector3d mean = sum / n;
    const Eigen::Vector3d m = min_spread_direction(squares() / n - mean * mean.transpose());
    return {m.x(), m.y(), m.z(), -m.dot(mean)};
  }
  /// Sum of x xᵀ.
  Eigen::Matrix3d squares() const { return square.selfadjointView<Eigen::Lower>(); }
};

}  // namespace quadrille
