#include "scene/free_supports.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "space/voxel_key.hpp"

namespace quadrille {
namespace {

// Far more than what rounding changes in the place of a plane that is given by another of its
// points [m].
constexpr double kSamePlace = 1e-9;

/// The planes on which targets stand, each once.
std::vector<SupportPlane> all_supports(const SceneParts& parts) {
  std::vector<SupportPlane> planes;
  for (const Target& target : parts.targets) {
    for (const SupportPlane& plane : target.supports) {
      const bool known = std::any_of(planes.begin(), planes.end(), [&](const SupportPlane& other) {
        return other.n_C() == plane.n_C() &&
               std::abs(other.distance(plane.X_CP.translation())) < kSamePlace;
      });
      if (!known) planes.push_back(plane);
    }
  }
  return planes;
}

/// Returns how many points above a plane a voxel must hold so that they are no strays: two where a
/// view has several in each voxel, else one.
std::size_t fewest_above(const SupportPlane& plane, const SceneParts& parts) {
  // With so many points along an edge, voxels of a plane seen at 60° have four or five of them.
  constexpr double kAlongEdge = 3.0;
  if (parts.views.empty() || !parts.views.front().valid()) return 1;
  const DepthView& view = parts.views.front();
  const double spacing = view.spacing(view.to_view(plane.X_CP.translation()).z());
  return kAlongEdge * spacing < parts.space->resolution() ? 2 : 1;
}

/// The voxels near a plane that hold points above it.
class VoxelsAbove {
 public:
  /// @param highest  height above which no point lies in a voxel near the plane [m]
  VoxelsAbove(const SupportPlane& plane, const SceneParts& parts, double highest)
      : edge_(parts.space->resolution()) {
    const auto low = static_cast<float>(plane.flatness()), high = static_cast<float>(highest);
    const Eigen::Vector3f n_C = plane.n_C().cast<float>();
    const auto offset = static_cast<float>(plane.n_C().dot(plane.X_CP.translation()));
    std::vector<VoxelKey> keys;
    for (const Eigen::Vector3f& p_C : parts.points.p_C) {
      const float height = n_C.x() * p_C.x() + n_C.y() * p_C.y() + n_C.z() * p_C.z() - offset;
      if (height > low && height < high) keys.push_back(voxel_key(p_C.cast<double>(), edge_));
    }
    std::sort(keys.begin(), keys.end());
    const std::size_t fewest = fewest_above(plane, parts);
    for (std::size_t n = fewest - 1; n < keys.size(); ++n) {
      const bool enough = keys[n] == keys[n + 1 - fewest];
      if (enough && (keys_.empty() || keys_.back() != keys[n])) keys_.push_back(keys[n]);
    }
  }

  bool contain(const Eigen::Vector3d& centre_C) const {
    return std::binary_search(keys_.begin(), keys_.end(), voxel_key(centre_C, edge_));
  }

 private:
  double edge_;
  std::vector<VoxelKey> keys_;
};

}  // namespace

void free_supports(SceneParts* parts, ObstacleMap* map) {
  for (Target& target : parts->targets) {
    for (SupportPlane& plane : target.supports) plane.gave_way = true;
  }
  for (const SupportPlane& plane : all_supports(*parts)) {
    // No part of a voxel lies farther from the plane than its centre does and this.
    const double reach = 0.5 * parts->space->resolution() * plane.n_C().cwiseAbs().sum();
    const double highest = plane.flatness() + reach;
    const VoxelsAbove above(plane, *parts, highest + reach);
    const Eigen::Isometry3d X_PC = plane.X_CP.inverse();
    const double spread = plane.n_C().cwiseAbs().sum();
    const auto may_free = [&](const Eigen::Vector3d& middle_C, double half) {
      return std::abs(plane.distance(middle_C)) < highest + half * spread;
    };
    map->free_occupied(may_free, [&](const Eigen::Vector3d& centre_C) {
      if (!(std::abs(plane.distance(centre_C)) < highest)) return false;
      // Beyond where the plane was seen, voxels may hold other things of its height.
      return plane.seen_P.contains((X_PC * centre_C).head<2>()) && !above.contain(centre_C);
    });
  }
}

}  // namespace quadrille
