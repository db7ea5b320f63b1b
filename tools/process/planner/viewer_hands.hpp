#pragma once

#include <vector>

#include "process/runtime/viewer.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// The hand at the best grasp, opened as it comes, as boxes: two fingers and the palm. Nothing if
/// there is no grasp.
std::vector<ViewerLink> hand_links(const GraspPlan& plan, const Gripper& gripper);

}  // namespace quadrille
