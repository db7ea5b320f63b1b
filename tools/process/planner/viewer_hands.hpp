#pragma once

#include <vector>

#include "process/runtime/viewer.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Returns the hand at the best grasp, opened as on its approach, as boxes: two fingers and the
/// palm. Empty if there is no grasp.
std::vector<ViewerLink> hand_links(const GraspPlan& plan, const Gripper& gripper);

}  // namespace quadrille
