#pragma once

#include "space/collision.hpp"
#include "targets/scene_parts.hpp"
#include "targets/target.hpp"
#include "targets/target_points.hpp"

namespace quadrille {

/// Returns the obstacles for a hand that takes a target as a solid. The target's own voxels are
/// removed; those of its support stay.
CollisionScene solid_scene(const Target& target, const SceneParts& parts);

/// Returns the obstacles for a hand that takes the target by its wall alone: the vessel's contents
/// and its hidden bottom stay obstacles.
CollisionScene shell_scene(const Target& target, const SceneParts& parts);

/// Returns the obstacles for a hand that takes the target by its seen points. The voxels about the
/// points are removed, and the points themselves are obstacles. If the target is known to be solid,
/// its shape is one too, with its hidden side.
CollisionScene point_scene(const Target& target, const TargetPoints& points,
                           const SceneParts& parts);

}  // namespace quadrille
