#include "fit/closed_form/initial_sphere.hpp"

#include "fit/closed_form/point_sums.hpp"

namespace quadrille {

std::optional<PosedQuadric> initial_sphere(const OrientedPointsf& p) {
  Eigen::Matrix<float, Eigen::Dynamic, 5> M(p.size(), 5);
  M << p.x().matrix(), p.y().matrix(), p.z().matrix(), Eigen::VectorXf::Ones(p.size()),
      (p.x().square() + p.y().square() + p.z().square()).matrix();
  const Eigen::Vector4d s = least_squares(M);
  const Eigen::Vector3d centre = 0.5 * s.head<3>();
  const double r2 = s[3] + centre.squaredNorm();
  if (!s.allFinite() || !(r2 > 0)) return std::nullopt;
  PosedQuadric sphere;
  sphere.X.translation() = centre;
  sphere.D.diagonal() << 1, 1, 1, -r2;
  return sphere;
}

}  // namespace quadrille
