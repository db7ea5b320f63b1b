#include "targets/target_points.hpp"

#include <algorithm>

namespace quadrille {
namespace {

// Points are thinned to one for each cube of this edge [m].
constexpr double kCell = 0.0025;
// Points up to this distance outside the box around a target belong to it [m].
constexpr double kOwn = 0.005;
// Points up to this height above a support belong to the support [m].
constexpr double kOnSupport = 0.006;

}  // namespace

TargetPoints points_about(const Target& target, const SceneParts& parts) {
  const Eigen::AlignedBox3d region = around(target.body, parts.gripper.max_opening);
  const Eigen::AlignedBox3f near = region.cast<float>();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : parts.points) {
    if (!near.contains(p)) continue;
    const Eigen::Vector3d p_C = p.cast<double>();
    const auto holds_up = [&](const SupportPlane& plane) {
      return plane.distance(p_C) < kOnSupport;
    };
    if (std::none_of(target.supports.begin(), target.supports.end(), holds_up)) {
      points.push_back(p_C);
    }
  }
  TargetPoints found{surface_points(points, kCell, parts.viewpoint_C), {}};
  for (const Eigen::Vector3d& p : found.all.p_C) found.own.push_back(target.body.contains(p, kOwn));
  return found;
}

}  // namespace quadrille
