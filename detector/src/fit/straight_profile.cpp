#include "fit/straight_profile.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Least slope with which the fit of a cone begins. Its apex is then 100 radii away.
constexpr double kLeastSlope = 0.01;
// Least variance of the heights of points, in local coordinates, over which a line is laid.
constexpr double kLeastHeight = 1e-9;

}  // namespace

ProfileLine profile_line(const OrientedPointsf& points, const Normalisation& local,
                         const Eigen::Isometry3d& X_CA) {
  Eigen::Isometry3d X = X_CA;
  X.translation() = (X_CA.translation() - local.centre) / local.scale;
  const Eigen::Isometry3d X_AL = X.inverse();
  double z = 0.0, r = 0.0, zz = 0.0, zr = 0.0;
  const auto n = static_cast<double>(points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = X_AL * Eigen::Vector3d(points.points.col(i).cast<double>());
    const double radius = p.head<2>().norm();
    z += p.z() / n, r += radius / n, zz += p.z() * p.z() / n, zr += p.z() * radius / n;
  }
  return {X, z, r, (zr - z * r) / std::max(zz - z * z, kLeastHeight)};
}

PosedQuadric straight_quadric(Family family, const ProfileLine& line, double slope) {
  PosedQuadric result;
  result.X = line.X;
  if (family == Family::kCylinder) {
    result.D = Eigen::Vector4d(1.0, 1.0, 0.0, -line.r * line.r).asDiagonal();
    return result;
  }
  const double k = std::copysign(std::max(kLeastSlope, std::abs(slope)), slope);
  result.D = Eigen::Vector4d(1.0, 1.0, -k * k, 0.0).asDiagonal();
  result.X.translation() += (line.z - line.r / k) * line.X.linear().col(2);
  return result;
}

}  // namespace quadrille
