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

/// A cone's axis and half angle, from its normals.
struct ConeAxis {
  Eigen::Vector3d a;
  double sine, cosine;
};

/// The axis to which each of three normals has the angle of its sign, nᵢ·a = sᵢ sin α; nullopt if
/// there is no such α.
std::optional<ConeAxis> cone_axis(const Eigen::Matrix3d& inverse_of_normals,
                                  const Eigen::Vector3d& signs) {
  const Eigen::Vector3d a = inverse_of_normals * signs;
  const double sine = 1.0 / a.norm();
  if (!(sine < 1.0)) return std::nullopt;
  return ConeAxis{sine * a, sine, std::sqrt(1.0 - sine * sine)};
}

/// The squared distances of three points from the rulings that have their normals, summed:
/// (xᵢ − p)·a = ∓ sᵢ |xᵢ − p| cos α, with one sign for all points.
double misfit(const ConeAxis& axis, const Eigen::Matrix3d& rays, const Eigen::Vector3d& signs) {
  const Eigen::Vector3d along = rays.transpose() * axis.a;
  const Eigen::Vector3d expected =
      axis.cosine * signs.cwiseProduct(rays.colwise().norm().transpose());
  return std::min((along - expected).squaredNorm(), (along + expected).squaredNorm());
}

/// True if a cone with a point on the other nappe agrees with the points as well as one of one
/// nappe does, whose misfit is given. Any three normals have a cone of either kind, so only the
/// points tell them apart.
bool may_be_on_both_nappes(const Eigen::Matrix3d& inverse_of_normals, const Eigen::Matrix3d& rays,
                           double one_nappe) {
  // Squared distances below this share of the squared extent are rounding errors.
  constexpr double kRounding = 1e-15;
  const double least = std::max(one_nappe, kRounding * rays.squaredNorm());
  for (int other = 0; other < 3; ++other) {
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    signs[other] = -1.0;
    const auto axis = cone_axis(inverse_of_normals, signs);
    if (axis && misfit(*axis, rays, signs) <= least) return true;
  }
  return false;
}

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
  const auto axis = cone_axis(inverse, Eigen::Vector3d::Ones());
  if (!axis) return std::nullopt;
  const auto& [a, sine, cosine] = *axis;
  Eigen::Matrix3d rays;
  for (int i = 0; i < 3; ++i) rays.col(i) = basis[static_cast<std::size_t>(i)].x - p;
  // A cone has two nappes; the apex must be on the same side of all three points.
  const Eigen::Vector3d along = rays.transpose() * a;
  if (along.minCoeff() < 0.0 && along.maxCoeff() > 0.0) return std::nullopt;
  const double one_nappe = misfit(*axis, rays, Eigen::Vector3d::Ones());
  if (may_be_on_both_nappes(inverse, rays, one_nappe)) return std::nullopt;
  const bool outwards = along.minCoeff() < 0.0;
  Eigen::Matrix4d Q;
  const Eigen::Matrix3d A = cosine * cosine * Eigen::Matrix3d::Identity() - a * a.transpose();
  Q << A, -A * p, -(A * p).transpose(), p.dot(A * p);
  return outwards ? Q : Eigen::Matrix4d(-Q);
}

}  // namespace quadrille
