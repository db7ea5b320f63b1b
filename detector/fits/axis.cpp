#include "fits/axis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "fit/closed_form/axis_of_revolution.hpp"
#include "fit/closed_form/point_sums.hpp"
#include "fits/solvers.hpp"

namespace quadrille {
namespace {

// If the last singular value has less than this share of the first, rounding of coordinates far
// from the origin, 1e-12 of the extent, turns a null vector by a millionth.
constexpr double kMinShare = 1e-6;

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

/// The directions of the lines that meet the normal lines of four points. Lines (a, m) that meet a
/// normal line (n, x × n) satisfy n·m + (x × n)·a = 0; four such equations leave a pencil, two
/// members of which are lines, a·m = 0.
std::vector<Eigen::Vector3d> lines_across_four(const OrientedPointsd& points) {
  Eigen::Matrix<double, 4, 6> H;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const OrientedPoint p = points.at(i);
    H.row(i) << p.x.cross(p.n).transpose(), p.n.transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix<double, 4, 6>> svd(H, Eigen::ComputeFullV);
  if (!(svd.singularValues()[3] > kMinShare * svd.singularValues()[0])) return {};
  const Eigen::Matrix<double, 6, 2> pencil = svd.matrixV().rightCols<2>();
  const Eigen::Matrix2d products = pencil.topRows<3>().transpose() * pencil.bottomRows<3>();
  // In the frame of the eigenvectors a·m = κ₁c² + κ₂s², which vanishes for c : s = ±√−κ₂ : √κ₁.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(
      Eigen::Matrix2d(0.5 * (products + products.transpose())));
  const Eigen::Vector2d kappa = eigen.eigenvalues();
  // If one is nearly zero, the two lines nearly coincide and rounding decides whether they exist.
  if (!(std::min(-kappa[0], kappa[1]) > kMinShare * std::max(-kappa[0], kappa[1]))) return {};
  std::vector<Eigen::Vector3d> directions;
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector2d at(std::sqrt(kappa[1]), sign * std::sqrt(-kappa[0]));
    directions.emplace_back((pencil.topRows<3>() * eigen.eigenvectors() * at).normalized());
  }
  return directions;
}

}  // namespace

std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPointsd& points) {
  const auto u = smallest_eigenvector(scatter_of(points.normals));
  if (!u) return std::nullopt;
  return Eigen::Vector3d(*u);
}

std::vector<Eigen::Vector3d> cone_axes(const OrientedPointsd& points, const Eigen::Vector3d& apex) {
  std::vector<Eigen::Vector3d> axes;
  for (const double side : {0.0, 1.0, -1.0}) {
    const Eigen::Matrix3Xd normals = on_one_nappe(points, apex, side);
    const Eigen::Matrix3Xd centred = normals.colwise() - normals.rowwise().mean().eval();
    const auto u = smallest_eigenvector(centred * centred.transpose());
    if (u) axes.emplace_back(*u);
  }
  return axes;
}

std::vector<Eigen::Vector3d> directions_of_revolution(const OrientedPointsd& points) {
  if (points.size() == 4) return lines_across_four(points);
  const auto axis = axis_of_revolution(points, 0.0);
  if (!axis || !is_unique(axis->misfits)) return {};
  return {axis->direction};
}

std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPointsd& points) {
  const Eigen::Matrix3d N = scatter_of(points.normals);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(N, Eigen::EigenvaluesOnly);
  if (!is_above_rounding(eigen.eigenvalues()[0], eigen.eigenvalues()[2])) return std::nullopt;
  return Eigen::Vector3d(N.ldlt().solve(sum_of_planes(points)));
}

}  // namespace quadrille
