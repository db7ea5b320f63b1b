#pragma once

#include <lcmtypes/quadrille/planner_status_t.hpp>
#include <string>

#include "process/planner/settings.hpp"

namespace quadrille {

/// The same for equal settings, whichever way they were given.
std::string hash_of(const PlannerSettings& settings);

/// A status in the text format that Prometheus reads.
std::string to_exposition(const planner_status_t& status, const PlannerSettings& settings);

}  // namespace quadrille
