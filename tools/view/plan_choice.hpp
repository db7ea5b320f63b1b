#pragma once

#include <compare>
#include <string>

namespace quadrille::view {

/// How to plan on a cloud of a log, where that is not as the command line says.
struct PlanChoice {
  /// A name of the session's list, and a word of UnknownPolicy; empty: as on the command line.
  std::string gripper, unknown;
  /// Of the hand from all but its target [m].
  double min_clearance = 0.0;

  friend auto operator<=>(const PlanChoice&, const PlanChoice&) = default;
};

}  // namespace quadrille::view
