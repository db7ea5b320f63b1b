#pragma once

#include <string>
#include <string_view>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Returns one readable line on a reason for which candidates were refused: what it means, and what
/// to try. Empty if there is no reason of that name.
/// @param reason  name as in GraspPlan::rejected
std::string advise(std::string_view reason, UnknownPolicy unknown);

/// Returns one readable line on why a plan has no grasps: the main reason in plain words, and what
/// to try. Reasons are weighed by the number of candidates that they ended.
std::string explain_no_grasps(const GraspPlan& plan, UnknownPolicy unknown);

}  // namespace quadrille
