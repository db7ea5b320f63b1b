#pragma once

#include "space/obstacle_map.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Frees the voxels that hold nothing but points of a plane on which a target stands, so that hands
/// go as near to the plane as its flatness() allows, and tells the planes so
/// (SupportPlane::gave_way). Voxels are as coarse as things that lie flat are high: those of the
/// plane would keep hands off such things.
void free_supports(SceneParts* parts, ObstacleMap* map);

}  // namespace quadrille
