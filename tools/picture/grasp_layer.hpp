#pragma once

#include "picture/image.hpp"
#include "picture/view.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Draws hands as glyphs of fingers, palm and approach: each target's first grasp bold with its
/// contacts, the next few thin.
void draw_grasps(const GraspPlan& plan, const Gripper& gripper, const View& view, Image* image);

}  // namespace quadrille
