#include "bodies/one_centre.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "bodies/axial_part.hpp"
#include "fit/family_spec.hpp"

namespace quadrille {
namespace {

// Number of unknowns of a centre.
constexpr int kCentre = 3;

/// The mean of the centres of the spheres among the sides.
Eigen::Vector3d mean_centre(const std::vector<Member>& sides) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double spheres = 0.0;
  for (const Member& side : sides) {
    const auto& [fit, local, points, weight, parallel_to] = side.part;
    if (fit.family != Family::kSphere) continue;
    sum += local.centre + local.scale * fit.posed.X.translation();
    spheres += 1.0;
  }
  return sum / spheres;
}

/// A side as a sphere about a centre.
CoaxialPart sphere_about(const Member& side, const Eigen::Vector3d& centre_C) {
  CoaxialPart part = side.part;
  const Eigen::Vector3d centre = (centre_C - part.local.centre) / part.local.scale;
  const Eigen::Vector3f at = centre.cast<float>();
  const double radius = (side.fit->points.points.colwise() - at).colwise().norm().mean();
  part.fit.family = Family::kSphere;
  part.fit.posed.X = Eigen::Isometry3d(Eigen::Translation3d(centre));
  part.fit.posed.D = Eigen::Vector4d(1.0, 1.0, 1.0, -radius * radius).asDiagonal();
  return part;
}

/// Numbers of surfaces that may be the two sides of one wall, the outer one first.
std::vector<std::pair<int, int>> perhaps_one_centre(std::span<const Detection> detections,
                                                    const std::vector<LastFit>& fits) {
  const auto part_of = [&](std::size_t k, bool inside) -> std::optional<AxialPart> {
    const Family family = fits[k].surface.fit.family;
    if (fits[k].points.size() == 0 || shows_inside(detections[k]) != inside) return std::nullopt;
    if (family != Family::kSphere && !has_one_axis(family)) return std::nullopt;
    return axial_part(detections[k]);
  };
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < detections.size(); ++a) {
    const std::optional<AxialPart> outer = part_of(a, false);
    if (!outer) continue;
    for (std::size_t b = 0; b < detections.size(); ++b) {
      if (fits[a].surface.fit.family != Family::kSphere &&
          fits[b].surface.fit.family != Family::kSphere) {
        continue;
      }
      const std::optional<AxialPart> inner = part_of(b, true);
      if (!inner || !share_axis(*outer, *inner, kPerhapsOneAxis)) continue;
      pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return pairs;
}

/// A wall that may be one, and by how much the criterion prefers one centre to two.
struct PossibleWall {
  CentredWall wall;
  double gain;
};

/// @return nullopt if their residuals grow by more than chance lets them, or if a side that was no
///   sphere alone fits better as what it was
std::optional<PossibleWall> fit_one_centre(std::vector<Member> sides) {
  const Eigen::Vector3d centre_C = mean_centre(sides);
  std::vector<CoaxialPart> parts;
  parts.reserve(sides.size());
  for (const Member& side : sides) parts.push_back(sphere_about(side, centre_C));
  parts.back().parallel_to = 0;
  std::optional<JointChoice> joint;
  try_parts(sides, std::move(parts), &joint);
  if (!joint) return std::nullopt;
  int fewer = -kCentre;
  double growth = 0.0, gain = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const FamilyFit &alone = sides[i].part.fit, &now = joint->fit.parts[i];
    fewer += family_spec(alone.family).dof - 1;
    growth += growth_of(sides[i], now);
    gain += bic_of(sides[i], alone, 0) - bic_of(sides[i], now, i > 0 ? kCentre : 0);
  }
  if (!(gain > 0.0) || !is_chance(growth, fewer)) return std::nullopt;
  return PossibleWall{{std::move(sides), std::move(joint->fit)}, gain};
}

/// True for each of these walls that shares no surface with one of greater gain that is kept.
std::vector<char> kept_walls(const std::vector<PossibleWall>& walls, std::size_t surfaces) {
  std::vector<std::size_t> best_first(walls.size());
  std::iota(best_first.begin(), best_first.end(), std::size_t{0});
  std::stable_sort(best_first.begin(), best_first.end(),
                   [&](std::size_t a, std::size_t b) { return walls[a].gain > walls[b].gain; });
  std::vector<char> taken(surfaces, 0), kept(walls.size(), 0);
  for (const std::size_t k : best_first) {
    const std::vector<Member>& sides = walls[k].wall.sides;
    const auto is_taken = [&](const Member& side) { return taken[side.index] != 0; };
    if (std::any_of(sides.begin(), sides.end(), is_taken)) continue;
    for (const Member& side : sides) taken[side.index] = 1;
    kept[k] = 1;
  }
  return kept;
}

}  // namespace

std::vector<CentredWall> find_centred_walls(std::span<const Detection> detections,
                                            const std::vector<LastFit>& fits) {
  std::vector<PossibleWall> walls;
  for (const auto& [a, b] : perhaps_one_centre(detections, fits)) {
    std::vector<Member> sides;
    for (const int k : {a, b}) {
      sides.push_back(member_of(k, fits[k], shows_inside(detections[k]), true));
    }
    std::optional<PossibleWall> wall = fit_one_centre(std::move(sides));
    if (wall) walls.push_back(std::move(*wall));
  }
  const std::vector<char> kept = kept_walls(walls, fits.size());
  std::vector<CentredWall> result;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (kept[k]) result.push_back(std::move(walls[k].wall));
  }
  return result;
}

}  // namespace quadrille
