#include "fit/closed_form/initial_sphere.hpp"

#include <Eigen/Cholesky>

namespace quadrille {

std::optional<PosedQuadric> initial_sphere(const PointMoments& moments) {
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 10, 5> columns;
  for (int k = 0; k < 3; ++k) columns.col(k) = quadratic(none, Eigen::Vector3d::Unit(k), 0.0);
  columns.col(3) = quadratic(none, Eigen::Vector3d::Zero(), 1.0);
  columns.col(4) = quadratic(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), 0.0);
  const Eigen::Vector4d s = least_squares(moments, columns);
  const Eigen::Vector3d centre = s.head<3>();
  const double r2 = s[3] + centre.squaredNorm();
  if (!s.allFinite() || !(r2 > 0)) return std::nullopt;
  PosedQuadric sphere;
  sphere.X.translation() = centre;
  sphere.D.diagonal() << 1, 1, 1, -r2;
  return sphere;
}

}  // namespace quadrille
