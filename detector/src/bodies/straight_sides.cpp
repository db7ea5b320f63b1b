#include "bodies/straight_sides.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace quadrille {
namespace {

// Least slope with which the fit of a cone begins. Its apex is then 100 radii away.
constexpr double kLeastSlope = 0.01;
// Least variance of the heights of points, in local coordinates, over which a line is laid.
constexpr double kLeastHeight = 1e-9;

/// The line of regression of the points' distances from an axis on their heights along it, in the
/// local coordinates of a member.
struct ProfileLine {
  /// Pose whose z axis is the axis.
  Eigen::Isometry3d X;
  /// Height and radius in the middle of the points, and the slope of the radius.
  double z, r, slope;
};

ProfileLine profile_line(const Member& member, const Eigen::Isometry3d& X_CA) {
  const Normalisation& local = member.part.local;
  Eigen::Isometry3d X = X_CA;
  X.translation() = (X_CA.translation() - local.centre) / local.scale;
  const Eigen::Isometry3d X_AL = X.inverse();
  double z = 0.0, r = 0.0, zz = 0.0, zr = 0.0;
  const OrientedPointsf& points = member.fit->points;
  const auto n = static_cast<double>(points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = X_AL * Eigen::Vector3d(points.points.col(i).cast<double>());
    const double radius = p.head<2>().norm();
    z += p.z() / n, r += radius / n, zz += p.z() * p.z() / n, zr += p.z() * radius / n;
  }
  return {X, z, r, (zr - z * r) / std::max(zz - z * z, kLeastHeight)};
}

/// The cylinder or cone whose profile is a line; the slope counts for cones only.
FamilyFit straight_fit(const Member& member, Family family, const ProfileLine& line, double slope) {
  FamilyFit fit = member.part.fit;
  fit.family = family;
  fit.posed.X = line.X;
  if (family == Family::kCylinder) {
    fit.posed.D = Eigen::Vector4d(1.0, 1.0, 0.0, -line.r * line.r).asDiagonal();
    return fit;
  }
  const double k = std::copysign(std::max(kLeastSlope, std::abs(slope)), slope);
  fit.posed.D = Eigen::Vector4d(1.0, 1.0, -k * k, 0.0).asDiagonal();
  fit.posed.X.translation() += (line.z - line.r / k) * line.X.linear().col(2);
  return fit;
}

}  // namespace

WallSides straight_wall(const std::vector<Member>& members) {
  std::optional<std::size_t> outer;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].is_inside) continue;
    if (!outer || members[i].part.fit.points > members[*outer].part.fit.points) outer = i;
  }
  if (!outer) return {};
  WallSides wall = {*outer};
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].is_inside) wall.push_back(i);
  }
  const auto is_line = [&](std::size_t i) { return is_straight(members[i].part.fit.family); };
  if (wall.size() < 2 || std::none_of(wall.begin(), wall.end(), is_line)) return {};
  return wall;
}

Eigen::Isometry3d mean_axis(const std::vector<Member>& members, const WallSides& wall) {
  Eigen::Vector3d sum_z = Eigen::Vector3d::Zero(), sum_p = Eigen::Vector3d::Zero();
  for (const std::size_t i : wall) {
    const Eigen::Isometry3d& X = members[i].part.fit.posed.X;
    const Normalisation& local = members[i].part.local;
    const Eigen::Vector3d z = X.linear().col(2), p = X.translation() - z.dot(X.translation()) * z;
    sum_z += z.dot(sum_z) < 0.0 ? Eigen::Vector3d(-z) : z;
    sum_p += local.centre + local.scale * p;
  }
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), sum_z).toRotationMatrix();
  X.translation() = sum_p / static_cast<double>(wall.size());
  return X;
}

void straighten(const std::vector<Member>& members, const WallSides& wall, Family family,
                const Eigen::Isometry3d& X_CA, std::vector<CoaxialPart>* parts) {
  double slope = 0.0, points = 0.0;
  std::vector<ProfileLine> lines;
  for (const std::size_t i : wall) {
    lines.push_back(profile_line(members[i], X_CA));
    slope += members[i].part.fit.points * lines.back().slope;
    points += members[i].part.fit.points;
  }
  for (std::size_t k = 0; k < wall.size(); ++k) {
    CoaxialPart& part = (*parts)[wall[k]];
    part.fit = straight_fit(members[wall[k]], family, lines[k], slope / points);
    part.parallel_to = k > 0 ? std::optional(wall.front()) : std::nullopt;
  }
}

}  // namespace quadrille
