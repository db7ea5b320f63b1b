#include "targets/target_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "targets/scene_parts.hpp"

namespace quadrille {
namespace {

// Points are thinned to one for each cube of this edge [m].
constexpr double kCell = 0.0025;
// Points up to this height above a support belong to the support [m].
constexpr double kOnSupport = 0.006;
// Far more than what rounding changes in the place of a plane that is given by another of its
// points [m].
constexpr double kSamePlace = 1e-9;

bool are_same(const SupportPlane& a, const SupportPlane& b) {
  return a.n_C() == b.n_C() && std::abs(a.distance(b.X_CP.translation())) < kSamePlace;
}

/// Returns true if two targets stand on the same planes, whichever is nearer.
bool are_same(const std::vector<SupportPlane>& a, const std::vector<SupportPlane>& b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const SupportPlane& plane) {
           return std::any_of(b.begin(), b.end(),
                              [&](const SupportPlane& other) { return are_same(plane, other); });
         });
}

/// The surroundings of the targets that stand on some planes.
std::vector<Eigen::AlignedBox3f> about_targets(const std::vector<SupportPlane>& supports,
                                               const SceneParts& parts) {
  std::vector<Eigen::AlignedBox3f> boxes;
  for (const Target& target : parts.targets) {
    if (!are_same(target.supports, supports)) continue;
    boxes.push_back(surroundings_of(target, parts).cast<float>());
  }
  return boxes;
}

PointSurface surface_above(const std::vector<SupportPlane>& supports, const SceneParts& parts) {
  const bool one_view = parts.views.size() == 1;
  std::vector<Eigen::Vector3d> points, eyes;
  if (one_view) eyes.push_back(parts.views.front().p_CV());
  parts.points.runs.each_in_any(about_targets(supports, parts), [&](std::size_t n) {
    const Eigen::Vector3d p_C = parts.points.p_C[n].cast<double>();
    const auto holds_up = [&](const SupportPlane& plane) {
      return plane.distance(p_C) < kOnSupport;
    };
    if (std::any_of(supports.begin(), supports.end(), holds_up)) return;
    points.push_back(p_C);
    if (!one_view) eyes.push_back(parts.views[parts.points.view[n]].p_CV());
  });
  return PointSurface(points, kCell, eyes);
}

}  // namespace

TargetSurfaces::TargetSurfaces(const std::vector<Target>& targets) {
  for (const Target& target : targets) {
    if (find(target) != nullptr) continue;
    shared_.push_back(std::make_unique<Shared>());
    shared_.back()->supports = target.supports;
  }
}

TargetSurfaces::Shared* TargetSurfaces::find(const Target& target) const {
  const auto shared = std::find_if(shared_.begin(), shared_.end(), [&](const auto& one) {
    return are_same(target.supports, one->supports);
  });
  return shared == shared_.end() ? nullptr : shared->get();
}

const PointSurface& TargetSurfaces::about(const Target& target, const SceneParts& parts) const {
  Shared& shared = *find(target);
  std::call_once(shared.once,
                 [&] { shared.surface.emplace(surface_above(shared.supports, parts)); });
  return *shared.surface;
}

Eigen::AlignedBox3d surroundings_of(const Target& target, const SceneParts& parts) {
  return around(target.body, parts.gripper.max_opening);
}

}  // namespace quadrille
