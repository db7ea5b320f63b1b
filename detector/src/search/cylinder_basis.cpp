#include "search/cylinder_basis.hpp"

#include <Eigen/Geometry>

namespace quadrille {
namespace {

// If the normals are closer to parallel, the axis is determined by noise.
constexpr double kMinSine = 0.17;

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

}  // namespace quadrille
