#include "bodies/one_centre.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

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

}  // namespace

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

std::optional<CoaxialFit> fit_one_centre(const std::vector<Member>& sides) {
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
  return std::move(joint->fit);
}

}  // namespace quadrille
