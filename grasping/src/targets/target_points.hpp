#pragma once

#include <vector>

#include "contacts/surface_points.hpp"
#include "quadrille/grasping/gripper.hpp"
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

/// Returns true if the target is a solid that is clearly wider than the hand opens, whichever way
/// the hand is turned, and hardly any of its points lie outside of it, as those of a handle would.
bool all_too_wide(const Target& target, const TargetPoints& points, const Gripper& gripper);

}  // namespace quadrille
