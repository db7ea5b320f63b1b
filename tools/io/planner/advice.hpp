#pragma once

#include <string>
#include <string_view>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Returns one readable line on a reason for which candidates were refused: what it means, and what
/// to try. Empty if there is no reason of that name.
/// @param reason  name as in GraspPlan::rejected
std::string advise(std::string_view reason, UnknownPolicy unknown);

/// Returns one readable line on why a target has no grasp: the reason that refused the candidates
/// that got furthest, how many these were, and what to do if only that can help.
std::string explain_no_grasp(const TargetOutcome& outcome);

}  // namespace quadrille
