#pragma once

#include <cstdint>
#include <stdexcept>

namespace quadrille::view {

/// Thrown when more questions are asked than a planner should have to answer.
struct TooManyQuestions : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A question of the page to the planner on the bus, for grasps of one object.
struct Question {
  /// The object's track, or 0 if it has none; then its id and the time of its cloud identify it.
  std::int32_t track = 0, target = 0;
  /// Time of the cloud [us].
  std::int64_t cloud_utime = 0;
  /// Least distance of the hand from everything but its target [m].
  double min_clearance = 0.0;
};

}  // namespace quadrille::view
