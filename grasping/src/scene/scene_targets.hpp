#pragma once

#include <vector>

#include "base/deadline.hpp"
#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "scene/view_clouds.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Chooses what of a scene can be grasped: detections, boxes, and bodies whose shape is not known.
/// Each target gets the view that shows most of it, and the support if the caller knows one.
/// Targets that do not fit on one map with the others are refused.
/// @param deadline  what is not looked at by then is refused
void choose_scene_targets(const ViewClouds& views, const std::vector<Detection>& detections,
                          const std::vector<SceneBody>& bodies, const Surroundings& known,
                          const Deadline& deadline, SceneParts* parts);

}  // namespace quadrille
