#include "fit/closed_form/axis_of_revolution.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/symmetric_eigen.hpp"
#include "fit/closed_form/point_sums.hpp"

namespace quadrille {

std::optional<AxisOfRevolution> axis_of_revolution(const Eigen::Matrix<double, 6, 6>& S,
                                                   double ridge) {
  // A normal line (n, x × n) meets the axis (a, m) if n·m + (x × n)·a = 0. This minimises
  // Σ (h·[a m])² subject to |a| = 1, with m eliminated.
  const Eigen::Matrix3d Smm =
      S.bottomRightCorner<3, 3>() +
      ridge * S.bottomRightCorner<3, 3>().trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d K = -Smm.ldlt().solve(Eigen::Matrix3d(S.bottomLeftCorner<3, 3>()));
  const Eigen::Matrix3d reduced = S.topLeftCorner<3, 3>() + S.topRightCorner<3, 3>() * K;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
      Eigen::Matrix3d(0.5 * (reduced + reduced.transpose())));
  AxisOfRevolution axis;
  axis.direction = eigen.eigenvectors().col(0);
  axis.foot = axis.direction.cross(Eigen::Vector3d(K * axis.direction));
  axis.misfits = eigen.eigenvalues();
  if (!axis.foot.allFinite()) return std::nullopt;
  return axis;
}

std::optional<AxisOfRevolution> axis_of_revolution(const OrientedPointsd& p, double ridge) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> H(p.size(), 6);
  H << (p.y() * p.nz() - p.z() * p.ny()).matrix(), (p.z() * p.nx() - p.x() * p.nz()).matrix(),
      (p.x() * p.ny() - p.y() * p.nx()).matrix(), p.nx().matrix(), p.ny().matrix(), p.nz().matrix();
  return axis_of_revolution(products_of_columns(H), ridge);
}

}  // namespace quadrille
