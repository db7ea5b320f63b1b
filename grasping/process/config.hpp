#pragma once

#include <string>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Reads the planner's settings from a TOML file: unknown, resolution [m], friction, approach [m],
/// pad_margin [m] and max_grasps. What the file leaves out keeps its default.
/// @throws io::FileError naming the file and line or field if it is missing or no TOML, if a key is
///   unknown, or if a value has the wrong type or is out of range
PlanOptions load_plan_options(const std::string& path);

}  // namespace quadrille
