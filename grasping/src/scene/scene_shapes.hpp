#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Adds the collision shapes of the scene's boxes and of the detections, with their owners. A box
/// takes the place of its faces. Detections that are to be grasped but have no shape are refused.
void add_shapes(const std::vector<Detection>& detections, SceneParts* parts);

}  // namespace quadrille
