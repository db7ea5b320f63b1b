#pragma once

#include <cstdint>
#include <stdexcept>

namespace quadrille::view {

/// Thrown when more is asked than a planner should have to answer.
struct TooManyQuestions : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the page asks the planner on the bus: grasps of one object.
struct Question {
  /// The object's track; 0: it has none, and is known by its id and the time of its cloud.
  std::int32_t track = 0, target = 0;
  /// [us]
  std::int64_t cloud_utime = 0;
  /// Of the hand from all but its target [m].
  double min_clearance = 0.0;
};

}  // namespace quadrille::view
