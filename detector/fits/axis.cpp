#include "fits/axis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>

#include "fit/closed_form/axis_of_revolution.hpp"
#include "fit/closed_form/point_sums.hpp"
#include "fits/solvers.hpp"

namespace quadrille {
namespace {

/// Returns the normals, with those on a cone's second nappe reversed. If r is the unit ray from the
/// apex and n the outward normal, r − n is within 45° of the axis on one nappe and of its opposite
/// on the other, whatever the cone's angle.
/// @param side  1 for outward normals, -1 for inward ones, 0 to reverse none
Eigen::Matrix3Xd on_one_nappe(const OrientedPointsd& points, const Eigen::Vector3d& apex,
                              double side) {
  Eigen::Matrix3Xd w = (points.points.colwise() - apex).colwise().normalized();
  w -= side * points.normals;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Eigen::Matrix3d(w * w.transpose()));
  const Eigen::Vector3d main = eigen.eigenvectors().col(2);
  Eigen::Matrix3Xd normals = points.normals;
  for (Eigen::Index i = 0; side != 0.0 && i < normals.cols(); ++i) {
    if (w.col(i).dot(main) < 0.0) normals.col(i) *= -1.0;
  }
  return normals;
}

}  // namespace

std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPointsd& points) {
  const auto u = smallest_eigenvector(scatter_of(points.normals));
  if (!u) return std::nullopt;
  return Eigen::Vector3d(*u);
}

std::optional<Eigen::Vector3d> cone_axis(const OrientedPointsd& points,
                                         const Eigen::Vector3d& apex) {
  std::optional<Eigen::Vector3d> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {0.0, 1.0, -1.0}) {
    const Eigen::Matrix3Xd normals = on_one_nappe(points, apex, side);
    const Eigen::Matrix3Xd centred = normals.colwise() - normals.rowwise().mean().eval();
    const Eigen::MatrixXd scatter = centred * centred.transpose();
    const auto u = smallest_eigenvector(scatter);
    if (!u || !(u->dot(scatter * *u) < least)) continue;
    least = u->dot(scatter * *u);
    best = Eigen::Vector3d(*u);
  }
  return best;
}

std::optional<Eigen::Vector3d> direction_of_revolution(const OrientedPointsd& points) {
  const auto axis = axis_of_revolution(points, 0.0);
  if (!axis || !is_unique(axis->misfits)) return std::nullopt;
  return axis->direction;
}

std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPointsd& points) {
  const auto p = solve_normal_equations(scatter_of(points.normals), sum_of_planes(points));
  if (!p) return std::nullopt;
  return Eigen::Vector3d(*p);
}

}  // namespace quadrille
