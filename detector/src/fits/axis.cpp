#include "axis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "solvers.hpp"

namespace quadrille {

std::optional<Eigen::Vector3d> direction_across_normals(const OrientedPoints& points) {
  const auto u = least_eigenvector(Eigen::MatrixXd(points.normals * points.normals.transpose()));
  if (!u) return std::nullopt;
  return Eigen::Vector3d(*u);
}

std::optional<Eigen::Vector3d> direction_at_constant_angle(const OrientedPoints& points) {
  const Eigen::Vector3d mean = points.normals.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.normals.colwise() - mean;
  const auto u = least_eigenvector(Eigen::MatrixXd(centred * centred.transpose()));
  if (!u) return std::nullopt;
  return Eigen::Vector3d(*u);
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
  const auto axis = least_eigenvector(Eigen::MatrixXd(S), Eigen::MatrixXd(metric));
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
