#include "fit/closed_form/initial_cylinder.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "base/symmetric_eigen.hpp"

namespace quadrille {
namespace {

/// Fits a circle to the points projected along the axis: its centre in the plane through the
/// origin, and its radius.
std::optional<std::pair<Eigen::Vector3d, double>> circle_across(const PointMoments& moments,
                                                                const Eigen::Vector3d& axis) {
  const Eigen::Matrix3d R = pose_along(Eigen::Vector3d::Zero(), axis).linear();
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 10, 4> columns;
  for (int k = 0; k < 2; ++k) columns.col(k) = quadratic(none, R.col(k), 0.0);
  columns.col(2) = quadratic(none, Eigen::Vector3d::Zero(), 1.0);
  columns.col(3) = quadratic(Eigen::Matrix3d::Identity() - axis * axis.transpose(),
                             Eigen::Vector3d::Zero(), 0.0);
  const Eigen::Vector3d s = least_squares(moments, columns);
  const double r2 = s[2] + s[0] * s[0] + s[1] * s[1];
  if (!(r2 > 0) || !s.allFinite()) return std::nullopt;
  return std::pair(Eigen::Vector3d(s[0] * R.col(0) + s[1] * R.col(1)), std::sqrt(r2));
}

}  // namespace

std::optional<PosedQuadric> initial_cylinder(const PointMoments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.normal_scatter());
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  const auto circle = circle_across(moments, axis);
  if (!circle) return std::nullopt;
  PosedQuadric cylinder;
  cylinder.X = pose_along(circle->first, axis);
  cylinder.D.diagonal() << 1, 1, 0, -circle->second * circle->second;
  return cylinder;
}

}  // namespace quadrille
