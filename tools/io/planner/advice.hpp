#pragma once

#include <string>
#include <string_view>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// One line for people on a reason for which candidates were refused: what it means, and what to
/// try; empty if there is none of that name.
/// @param reason  as in GraspPlan::rejected
std::string advise(std::string_view reason, UnknownPolicy unknown);

/// One line for people on why a plan has no grasps: the main reason in plain words, and what to
/// try. Reasons are weighed by how many candidates they ended.
std::string explain_no_grasps(const GraspPlan& plan, UnknownPolicy unknown);

}  // namespace quadrille
