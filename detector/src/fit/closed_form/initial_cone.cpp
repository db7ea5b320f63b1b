#include "fit/closed_form/initial_cone.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "base/symmetric_eigen.hpp"

namespace quadrille {

std::optional<PosedQuadric> initial_cone(const PointMoments& moments) {
  const Eigen::Vector3d n = moments.mean_normal();
  const Eigen::Matrix3d N = moments.normal_scatter();
  const Eigen::Matrix3d S = N - static_cast<double>(moments.size) * n * n.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  // The apex lies in each tangent plane: nᵢ·apex = nᵢ·xᵢ.
  const Eigen::Vector3d apex = N.ldlt().solve(moments.normals.block<3, 1>(3, 6));
  // All unit normals have the same component along the axis, and so has their mean.
  const double sine = std::abs(n.dot(axis));
  if (!apex.allFinite() || apex.norm() > 1e3 || sine < 1e-3 || sine > 0.999) return std::nullopt;
  const double k2 = sine * sine / (1 - sine * sine);
  PosedQuadric cone;
  cone.X = pose_along(apex, axis);
  cone.D.diagonal() << 1, 1, -k2, 0;
  return cone;
}

}  // namespace quadrille
