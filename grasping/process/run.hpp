#pragma once

#include "settings.hpp"

namespace quadrille {

/// Works on the bus until a stop is requested.
void run_on_bus(const PlannerSettings& settings);

/// Works through a log of clouds and quadrics.
/// @throws std::runtime_error if a log cannot be used, or the planning failed on a pair
void run_on_log(const PlannerSettings& settings);

}  // namespace quadrille
