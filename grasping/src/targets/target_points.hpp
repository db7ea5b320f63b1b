#pragma once

#include <vector>

#include "contacts/surface_points.hpp"
#include "targets/scene_parts.hpp"
#include "targets/target.hpp"

namespace quadrille {

/// The points about a target, without those of its supports.
struct TargetPoints {
  SurfacePoints all;
  /// For each point, nonzero if it lies in the target's body, or is connected to one that does by
  /// points of no other target.
  std::vector<char> own;
};
TargetPoints points_about(const Target& target, const SceneParts& parts);

}  // namespace quadrille
