#pragma once

#include <compare>
#include <string>

namespace quadrille::view {

/// Settings for planning on a cloud of a log that differ from those of the command line.
struct PlanChoice {
  /// A gripper from the session's list, and a word of UnknownPolicy; empty means as on the command
  /// line.
  std::string gripper, unknown;
  /// Least distance of the hand from everything but its target [m].
  double min_clearance = 0.0;

  friend auto operator<=>(const PlanChoice&, const PlanChoice&) = default;
};

}  // namespace quadrille::view
