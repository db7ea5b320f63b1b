#include "fit/closed_form/initial_cylinder.hpp"

#include <cmath>
#include <utility>

#include "base/symmetric_eigen.hpp"
#include "fit/closed_form/point_sums.hpp"

namespace quadrille {
namespace {

/// Fits a circle to the points projected along the axis: its centre in the plane through the
/// origin, and its radius.
std::optional<std::pair<Eigen::Vector3d, double>> circle_across(const OrientedPointsf& p,
                                                                const Eigen::Vector3d& axis) {
  const Eigen::Matrix3d R = pose_along(Eigen::Vector3d::Zero(), axis).linear();
  const Eigen::Vector3f e1 = R.col(0).cast<float>(), e2 = R.col(1).cast<float>();
  Eigen::Matrix<float, Eigen::Dynamic, 4> M(p.size(), 4);
  M.col(0) = (e1.x() * p.x() + e1.y() * p.y() + e1.z() * p.z()).matrix();
  M.col(1) = (e2.x() * p.x() + e2.y() * p.y() + e2.z() * p.z()).matrix();
  M.col(2).setOnes();
  M.col(3) = (M.col(0).array().square() + M.col(1).array().square()).matrix();
  const Eigen::Vector3d s = least_squares(M);
  const double r2 = s[2] + 0.25 * (s[0] * s[0] + s[1] * s[1]);
  if (!(r2 > 0) || !s.allFinite()) return std::nullopt;
  return std::pair(Eigen::Vector3d(0.5 * (s[0] * R.col(0) + s[1] * R.col(1))), std::sqrt(r2));
}

}  // namespace

std::optional<PosedQuadric> initial_cylinder(const OrientedPointsf& p) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter_of(p.normals));
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  const auto circle = circle_across(p, axis);
  if (!circle) return std::nullopt;
  PosedQuadric cylinder;
  cylinder.X = pose_along(circle->first, axis);
  cylinder.D.diagonal() << 1, 1, 0, -circle->second * circle->second;
  return cylinder;
}

}  // namespace quadrille
