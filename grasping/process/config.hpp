#pragma once

#include <string>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Reads the planner's settings from a TOML file: unknown, resolution [m], friction, max_grasps.
/// What the file leaves out keeps its default.
/// @throws io::FileError naming line and key if the file is missing or no TOML, if a key is
/// unknown,
///   or if a value has the wrong type
/// @throws std::invalid_argument naming the field that is out of range
PlanOptions load_plan_options(const std::string& path);

}  // namespace quadrille
