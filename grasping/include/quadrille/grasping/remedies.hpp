#pragma once

#include <optional>
#include <vector>

#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Plans again with one other setting at a time for the targets without a grasp, and returns what
/// helped: a lower score, conditions of the query left out, unknown space as free, half the
/// approach, other built-in hands. Each takes about as long as a plan.
/// @param plan  the plan for the other parameters, which are those of plan_grasps()
/// @throws std::invalid_argument if gripper, options, surroundings or query are out of range
QUADRILLE_EXPORT std::vector<Remedy> find_remedies(
    const GraspPlan& plan, const PointCloud& cloud, const std::vector<Detection>& detections,
    const Gripper& gripper, const PlanOptions& options = {}, const Surroundings& known = {},
    const GraspQuery& query = {}, std::optional<std::vector<Box>> boxes = {},
    const std::vector<SceneBody>& bodies = {});

}  // namespace quadrille
