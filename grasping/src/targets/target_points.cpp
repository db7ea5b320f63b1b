#include "targets/target_points.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/point_buckets.hpp"
#include "targets/target_surfaces.hpp"

namespace quadrille {
namespace {

// Points up to this distance outside the box around a target belong to it [m].
constexpr double kOwn = 0.005;
// Points are connected if they lie no farther apart than this [m].
constexpr double kApart = 0.0055;
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
  // Points that are decided: own ones, and others that may not be own. Where all points near a cube
  // are decided, its further points add nothing.
  std::vector<char> decided = own, all_decided(near.size(), 0);
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    const std::size_t cube = cube_of[i];
    if (all_decided[cube]) continue;
    bool all = true;
    for (const std::span<const int> row : near[cube]) {
      for (const int j : row) {
        // Unlike vectors, these do not check each access.
        if (decided.data()[j]) continue;
        if ((points.data()[j] - points.data()[i]).norm() > kApart) {
          all = false;
          continue;
        }
        decided[j] = 1;
        if (!may_be_own(points[j])) continue;
        own[j] = 1;
        open.push_back(static_cast<std::size_t>(j));
      }
    }
    all_decided[cube] = all;
  }
}

}  // namespace

TargetPoints points_about(const Target& target, const SceneParts& parts) {
  TargetPoints found{parts.surfaces.about(target, parts).within(surroundings_of(target, parts)),
                     {}};
  const Eigen::Isometry3d X_QC = target.body.X_CQ.inverse();
  found.own.reserve(found.all.p_C.size());
  for (const Eigen::Vector3d& p_C : found.all.p_C) {
    found.own.push_back(target.body.contains_Q(X_QC * p_C, kOwn));
  }
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
