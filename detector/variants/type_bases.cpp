#include "variants/type_bases.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// If the normals are closer to parallel, the axis is determined by noise.
constexpr double kMinSine = 0.17;
// If the normals have a smaller triple product, apex and axis are determined by noise.
constexpr double kMinTripleProduct = 0.005;

}  // namespace

std::optional<Eigen::Matrix4d> cylinder_through(const std::array<OrientedPoint, 2>& basis) {
  const auto& [first, second] = basis;
  const Eigen::Vector3d cross = first.n.cross(second.n);
  if (!(cross.norm() > kMinSine)) return std::nullopt;
  const Eigen::Vector3d u = cross.normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - u * u.transpose();
  const Eigen::Vector3d n = first.n - second.n;
  const double r = (across * (first.x - second.x)).dot(n) / n.squaredNorm();
  const Eigen::Vector3d c = across * (0.5 * (first.x + second.x) - 0.5 * r * (first.n + second.n));
  if (!(std::abs(r) > 0.0)) return std::nullopt;
  Eigen::Matrix4d Q;
  Q << across, -c, -c.transpose(), c.squaredNorm() - r * r;
  return r > 0.0 ? Q : Eigen::Matrix4d(-Q);
}

std::optional<Eigen::Matrix4d> cone_through(const std::array<OrientedPoint, 3>& basis) {
  Eigen::Matrix3d N;
  Eigen::Vector3d heights;
  for (int i = 0; i < 3; ++i) {
    const OrientedPoint& point = basis[static_cast<std::size_t>(i)];
    N.row(i) = point.n.transpose();
    heights[i] = point.n.dot(point.x);
  }
  if (!(std::abs(N.determinant()) > kMinTripleProduct)) return std::nullopt;
  const Eigen::Matrix3d inverse = N.inverse();
  const Eigen::Vector3d p = inverse * heights;
  // With normals that point inwards, n·a / sin α = 1.
  Eigen::Vector3d a = inverse * Eigen::Vector3d::Ones();
  const double sine = 1.0 / a.norm();
  if (!(sine < 1.0)) return std::nullopt;
  a *= sine;
  double least = 0.0, most = 0.0;
  for (const OrientedPoint& point : basis) {
    const double along = a.dot(point.x - p);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  // A cone has two nappes; the apex must be on the same side of all three points.
  if (least < 0.0 && most > 0.0) return std::nullopt;
  const bool outwards = least < 0.0;
  Eigen::Matrix4d Q;
  const Eigen::Matrix3d A = (1.0 - sine * sine) * Eigen::Matrix3d::Identity() - a * a.transpose();
  Q << A, -A * p, -(A * p).transpose(), p.dot(A * p);
  return outwards ? Q : Eigen::Matrix4d(-Q);
}

}  // namespace quadrille
