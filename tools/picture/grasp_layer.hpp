#pragma once

#include <Eigen/Core>
#include <vector>

#include "picture/sketch.hpp"
#include "picture/view.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Draws hands as glyphs of fingers, palm and approach: each target's first grasp bold with its
/// contacts, the next few thin.
Sketch sketch_grasps(const GraspPlan& plan, const Gripper& gripper, const View& view);

/// Returns the starts of the approaches of each target's first grasp, in frame C.
std::vector<Eigen::Vector3d> hand_points(const GraspPlan& plan, const Gripper& gripper);

}  // namespace quadrille
