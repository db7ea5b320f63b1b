#pragma once

#include <string>
#include <vector>

#include "cli/paint.hpp"
#include "io/json.hpp"
#include "lab/physics/attempts.hpp"
#include "view/scene_tables.hpp"

namespace quadrille {

/// The attempts of one input for people, a line each.
std::string attempt_table(const std::string& input, const std::vector<physics::Attempt>& attempts,
                          const Paint& paint);

/// Attempts summed up: all of them, the first of each target, and the first ones by type of object.
std::string attempt_summary(const std::vector<physics::Attempt>& attempts);

/// The same sums as a table.
view::ReportTable attempt_summary_table(const std::vector<physics::Attempt>& attempts);

/// The attempts of one input, slip in metres, rotation in radians, with their summary.
io::Json attempts_json(const std::string& input, const std::vector<physics::Attempt>& attempts);

}  // namespace quadrille
