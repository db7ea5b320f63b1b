#include "quadrille/detector/quadric.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace quadrille {

Quadric::Quadric(const Vector10d& q) {
  const auto [A, B, C, D, E, F] = std::tuple(q[0], q[1], q[2], q[3], q[4], q[5]);
  const auto [G, H, I, J] = std::tuple(q[6], q[7], q[8], q[9]);
  Q_ << A, D, E, G,  //
      D, B, F, H,    //
      E, F, C, I,    //
      G, H, I, J;
}

Vector10d Quadric::coefficients() const {
  Vector10d q;
  q << Q_(0, 0), Q_(1, 1), Q_(2, 2), Q_(0, 1), Q_(0, 2), Q_(1, 2), Q_(0, 3), Q_(1, 3), Q_(2, 3),
      Q_(3, 3);
  return q;
}

Quadric Quadric::normalized() const {
  const double norm = coefficients().norm();
  return norm > 0.0 ? Quadric(Eigen::Matrix4d(Q_ / norm)) : *this;
}

double Quadric::value(const Eigen::Vector3d& x) const {
  return x.homogeneous().dot(Q_ * x.homogeneous());
}

Eigen::Vector3d Quadric::gradient(const Eigen::Vector3d& x) const {
  return 2.0 * Q_.topRows<3>() * x.homogeneous();
}

double Quadric::distance(const Eigen::Vector3d& x) const {
  const double slope = gradient(x).norm();
  const double f = value(x);
  if (slope > 0.0) return f / slope;
  return f == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
}

std::array<double, 2> Quadric::crossings(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const {
  // f(o + t d) = a t² + 2 b t + c.
  const Eigen::Matrix3d A = Q_.topLeftCorner<3, 3>();
  const Eigen::Vector3d g = Q_.topRightCorner<3, 1>();
  const double a = d.dot(A * d), b = d.dot(A * o + g), c = o.dot(A * o + 2.0 * g) + Q_(3, 3);
  const double square = b * b - a * c;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (!(square > 0.0)) return {kNone, kNone};
  // This form avoids cancellation, as on planes and along rulings, where a nearly vanishes; s is
  // never zero here.
  const double s = -(b + std::copysign(std::sqrt(square), b));
  return {c / s, s / a};
}

Quadric Quadric::transformed(const Eigen::Isometry3d& X_BA) const {
  const Eigen::Matrix4d X_AB = X_BA.inverse().matrix();
  return Quadric(Eigen::Matrix4d(X_AB.transpose() * Q_ * X_AB));
}

Quadric Quadric::transformed(const Eigen::Projective3d& P_BA) const {
  const Eigen::FullPivLU<Eigen::Matrix4d> lu(P_BA.matrix());
  if (!P_BA.matrix().allFinite() || !lu.isInvertible()) {
    throw std::invalid_argument("Quadric::transformed: the map is singular or not finite");
  }
  const Eigen::Matrix4d P_AB = lu.inverse();
  return Quadric(Eigen::Matrix4d(P_AB.transpose() * Q_ * P_AB));
}

Eigen::Matrix4d Quadric::dual() const {
  Eigen::Matrix4d adjugate;
  for (int row = 0; row < 4; ++row) {
    for (int col = 0; col < 4; ++col) {
      Eigen::Matrix3d minor;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) minor(i, j) = Q_(i + (i >= row), j + (j >= col));
      }
      adjugate(col, row) = ((row + col) % 2 ? -1.0 : 1.0) * minor.determinant();
    }
  }
  return adjugate;
}

}  // namespace quadrille
