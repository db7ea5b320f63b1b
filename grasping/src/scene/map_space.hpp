#pragma once

#include "quadrille/grasping/surroundings.hpp"
#include "scene/view_clouds.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Maps the space around the targets of a scene, with what the caller knows of it, and keeps the
/// points there. If there are targets, their obstacles are mapped too. Far targets make the map
/// coarser, which is warned of.
void map_space(const ViewClouds& views, const Surroundings& known, SceneParts* parts);

}  // namespace quadrille
