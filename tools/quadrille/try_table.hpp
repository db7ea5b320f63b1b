#pragma once

#include <string>
#include <vector>

#include "cli/paint.hpp"
#include "io/json/json.hpp"
#include "lab/physics/attempts.hpp"
#include "view/scene/scene_tables.hpp"

namespace quadrille {

/// Returns a readable table of the attempts of one input, one per line.
std::string attempt_table(const std::string& input, const std::vector<physics::Attempt>& attempts,
                          const Paint& paint);

/// Sums up attempts: all of them, the first of each target, and the first ones by type of object.
std::string attempt_summary(const std::vector<physics::Attempt>& attempts);

/// Returns the same sums as a table.
view::ReportTable attempt_summary_table(const std::vector<physics::Attempt>& attempts);

/// Returns the attempts of one input, with slip in metres and rotation in radians, and their
/// summary.
io::Json attempts_json(const std::string& input, const std::vector<physics::Attempt>& attempts);

}  // namespace quadrille
