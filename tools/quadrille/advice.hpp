#pragma once

#include <string>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// One line for people on why a plan has no grasps: the main reason in plain words, and what to
/// try. Reasons are weighed by how many candidates they ended.
std::string explain_no_grasps(const GraspPlan& plan, UnknownPolicy unknown);

}  // namespace quadrille
