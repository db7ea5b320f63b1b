#include "fits/axis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>

#include "fits/solvers.hpp"

namespace quadrille {
namespace {

/// The normals with those of a cone's second nappe turned round. With r the ray from the apex and n
/// the outward normal, r − n is within 45° of the axis on one nappe and of its opposite on the
/// other, whatever the cone's angle.
/// @param side  1 for outward normals, -1 for inward ones, 0 to turn none
Eigen::Matrix3Xd on_one_nappe(const OrientedPoints& points, const Eigen::Vector3d& apex,
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

std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPoints& points) {
  const auto u = smallest_eigenvector(Eigen::MatrixXd(points.normals * points.normals.transpose()));
  if (!u) return std::nullopt;
  return Eigen::Vector3d(*u);
}

std::optional<Eigen::Vector3d> cone_axis(const OrientedPoints& points,
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

std::optional<Eigen::Vector3d> direction_of_revolution(const OrientedPoints& points) {
  // A normal line (n, x × n) meets the axis (a, m) where n·m + (x × n)·a = 0.
  Eigen::Matrix<double, 6, 6> S = Eigen::Matrix<double, 6, 6>::Zero();
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i), n = points.normals.col(i);
    Eigen::Vector<double, 6> line;
    line << x.cross(n), n;
    S += line * line.transpose();
  }
  // Only a has a norm: the metric leaves m free.
  Eigen::Matrix<double, 6, 6> metric = Eigen::Matrix<double, 6, 6>::Zero();
  metric.topLeftCorner<3, 3>().setIdentity();
  const auto axis = smallest_eigenvector(Eigen::MatrixXd(S), Eigen::MatrixXd(metric));
  if (!axis) return std::nullopt;
  return Eigen::Vector3d(axis->head<3>().normalized());
}

std::optional<Eigen::Vector3d> common_point_of_planes(const OrientedPoints& points) {
  const Eigen::Matrix3d N = points.normals * points.normals.transpose();
  const Eigen::Vector3d b =
      points.normals * points.normals.cwiseProduct(points.points).colwise().sum().transpose();
  const auto p = solve_normal_equations(Eigen::MatrixXd(N), Eigen::VectorXd(b));
  if (!p) return std::nullopt;
  return Eigen::Vector3d(*p);
}

}  // namespace quadrille
