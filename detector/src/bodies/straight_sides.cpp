#include "bodies/straight_sides.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/straight_profile.hpp"

namespace quadrille {
namespace {

/// The cylinder or cone of a member whose profile is a line; the slope counts for cones only.
FamilyFit straight_fit(const Member& member, Family family, const ProfileLine& line, double slope) {
  FamilyFit fit = member.part.fit;
  fit.family = family;
  fit.posed = straight_quadric(family, line, slope);
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
    lines.push_back(profile_line(members[i].fit->points, members[i].part.local, X_CA));
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
