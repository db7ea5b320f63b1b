#include "fits/type_design.hpp"

#include <Eigen/Geometry>

#include "fits/fit_scatter.hpp"
#include "fits/solvers.hpp"

namespace quadrille {
namespace {

/// The coefficients of the product of two affine functions.
Vector10d product(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  return Quadric(symmetric_product(a, b)).coefficients();
}

/// The affine functions u·x and 1.
Eigen::Vector4d linear(const Eigen::Vector3d& u) { return {u.x(), u.y(), u.z(), 0.0}; }
const Eigen::Vector4d kOne = Eigen::Vector4d::UnitW();

/// The coefficients of |x − p|².
Vector10d square_distance(const Eigen::Vector3d& p) {
  Vector10d q;
  q << 1, 1, 1, 0, 0, 0, -p, p.squaredNorm();
  return q;
}

/// The coefficients of (u·(x − p))².
Vector10d square_along(const Eigen::Vector3d& u, const Eigen::Vector3d& p) {
  const Eigen::Vector4d along(u.x(), u.y(), u.z(), -u.dot(p));
  return product(along, along);
}

}  // namespace

Design plane_design() {
  Design B = Design::Zero(10, 4);
  B.bottomRows<4>().setIdentity();
  return B;
}

Design sphere_design() {
  Design B(10, 5);
  B << square_distance(Eigen::Vector3d::Zero()), plane_design();
  return B;
}

Design spheroid_design(const Eigen::Vector3d& u) {
  Design B(10, 6);
  B << sphere_design(), square_along(u, Eigen::Vector3d::Zero());
  return B;
}

Design cylinder_design(const Eigen::Vector3d& u) {
  const Eigen::Vector3d e = u.unitOrthogonal(), zero = Eigen::Vector3d::Zero();
  Design B(10, 4);
  B << square_distance(zero) - square_along(u, zero), product(linear(e), kOne),
      product(linear(u.cross(e)), kOne), product(kOne, kOne);
  return B;
}

Design extrusion_design(const Eigen::Vector3d& u) {
  const Eigen::Vector4d x = linear(u.unitOrthogonal()), y = linear(u.cross(u.unitOrthogonal()));
  Design B(10, 6);
  B << product(x, x), product(y, y), product(x, y), product(x, kOne), product(y, kOne),
      product(kOne, kOne);
  return B;
}

Design paraboloid_design(const Eigen::Vector3d& u) {
  Design B(10, 7);
  B << extrusion_design(u), product(linear(u), kOne);
  return B;
}

Design cone_design(const Eigen::Vector3d& p, const Eigen::Vector3d& u) {
  Design B(10, 2);
  B << square_distance(p), square_along(u, p);
  return B;
}

Design elliptic_cone_design(const Eigen::Vector3d& p) {
  Design B(10, 6);
  int column = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      Eigen::Vector4d a = Eigen::Vector4d::Unit(i), b = Eigen::Vector4d::Unit(j);
      a[3] = -p[i], b[3] = -p[j];
      B.col(column++) = product(a, b);
    }
  }
  return B;
}

LinearSystem restricted(const LinearSystem& system, const Design& B) {
  return {system.A * B, system.n};
}

double mean_misfit(const Scatter& scatter, const Quadric& Q, double weight) {
  const Vector10d q = Q.coefficients();
  return q.dot((scatter.values + weight * weight * scatter.across()) * q) /
         q.dot(scatter.gradients * q);
}

std::optional<Quadric> fit_design(const Scatter& scatter, const Design& B, double weight) {
  const Matrix10d S = scatter.values + weight * weight * scatter.across();
  const auto theta = smallest_eigenvector(Eigen::MatrixXd(B.transpose() * S * B),
                                          Eigen::MatrixXd(B.transpose() * scatter.gradients * B));
  if (!theta) return std::nullopt;
  return Quadric(Vector10d(B * *theta));
}

std::optional<Quadric> fit_design(const OrientedPointsd& points, const Design& B, double weight) {
  return fit_design(Scatter(points), B, weight);
}

}  // namespace quadrille
