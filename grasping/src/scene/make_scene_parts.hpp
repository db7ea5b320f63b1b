#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/surroundings.hpp"
#include "targets/scene_parts.hpp"

namespace quadrille {

/// Prepares a cloud stage by stage: boxes (unless they are given), shapes, view, targets,
/// occupancy. Targets are chosen within half of the deadline [ms], which leaves the other half to
/// try them; 0 means no deadline. If all of it has passed by then, no target is left and space is
/// not mapped.
std::unique_ptr<const SceneParts> make_scene_parts(
    const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
    const PlanOptions& options, const Surroundings& known, std::optional<std::vector<Box>> boxes,
    const std::vector<SceneBody>& bodies, double deadline_ms);

}  // namespace quadrille
