#include "targets/target_points.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/point_buckets.hpp"

namespace quadrille {
namespace {

// Points are thinned to one for each cube of this edge [m].
constexpr double kCell = 0.0025;
// Points up to this distance outside the box around a target belong to it [m].
constexpr double kOwn = 0.005;
// Points are connected if they lie no farther apart than this [m].
constexpr double kApart = 0.0055;
// Points up to this height above a support belong to the support [m].
constexpr double kOnSupport = 0.006;
// A solid is clearly too wide above this share of the opening: of 26 such solids in simulated and
// real scenes none was ever held by its points. One with a share of 1.09 was. Points this far
// outside of the solid [m], if there are at least so many of them, may be a part to hold.
constexpr double kWideShare = 1.1, kOutside = 0.01;
constexpr int kMinOutside = 8;

/// Marks all points as own that are connected with own points and may be own.
template <class MayBeOwn>
void mark_connected(const std::vector<Eigen::Vector3d>& points, MayBeOwn&& may_be_own,
                    std::vector<char>& own) {
  const PointBuckets buckets(points, kApart);
  const std::vector<PointBuckets::Near> near = buckets.near_each();
  std::vector<std::size_t> cube_of(points.size());
  for (std::size_t n = 0; n < near.size(); ++n) {
    for (const int i : buckets.members(n)) cube_of[static_cast<std::size_t>(i)] = n;
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]) open.push_back(i);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    for (const std::span<const int> row : near[cube_of[i]]) {
      for (const int j : row) {
        if (own[j] || (points[j] - points[i]).norm() > kApart || !may_be_own(points[j])) continue;
        own[j] = 1;
        open.push_back(static_cast<std::size_t>(j));
      }
    }
  }
}

}  // namespace

TargetPoints points_about(const Target& target, const SceneParts& parts) {
  const Eigen::AlignedBox3d region = around(target.body, parts.gripper.max_opening);
  const Eigen::AlignedBox3f near = region.cast<float>();
  std::vector<Eigen::Vector3d> points, eyes;
  parts.points.runs.each_in(near, [&](std::size_t n) {
    const Eigen::Vector3d p_C = parts.points.p_C[n].cast<double>();
    const auto holds_up = [&](const SupportPlane& plane) {
      return plane.distance(p_C) < kOnSupport;
    };
    if (std::none_of(target.supports.begin(), target.supports.end(), holds_up)) {
      points.push_back(p_C);
      eyes.push_back(parts.views[parts.points.view[n]].p_CV());
    }
  });
  TargetPoints found{surface_points(points, kCell, eyes), {}};
  for (const Eigen::Vector3d& p : found.all.p_C) found.own.push_back(target.body.contains(p, kOwn));
  if (target.whole) return found;
  const auto of_no_other = [&](const Eigen::Vector3d& p_C) {
    return std::none_of(parts.targets.begin(), parts.targets.end(), [&](const Target& other) {
      return other.id != target.id && other.body.contains(p_C, kOwn);
    });
  };
  mark_connected(found.all.p_C, of_no_other, found.own);
  return found;
}

bool all_too_wide(const Target& target, const TargetPoints& points, const Gripper& gripper) {
  const double width = target.body.bounds_Q().sizes().minCoeff();
  if (!target.solid || width < kWideShare * gripper.max_opening) return false;
  int outside = 0;
  for (std::size_t i = 0; i < points.own.size(); ++i) {
    outside += points.own[i] && !target.body.contains(points.all.p_C[i], kOutside);
  }
  return outside < kMinOutside;
}

}  // namespace quadrille
