#pragma once

#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <string>

#include "process/planner/settings.hpp"

namespace quadrille {

/// Returns a hash that is the same for equal settings, however they were given.
std::string hash_of(const PlannerSettings& settings);

/// Formats a status in the text format that Prometheus reads.
std::string to_exposition(const planner_status_t& status, const PlannerSettings& settings);

}  // namespace quadrille
