#pragma once

#include <Eigen/Core>
#include <limits>

namespace quadrille {

/// How well a thing that was seen before matches one of a new cloud.
struct LookMatch {
  /// The translation that carries it there [m].
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
  /// Squared difference in standard deviations; infinite if they cannot be the same.
  double cost = std::numeric_limits<double>::infinity();
};

/// How a thing that was seen before may have moved since, and how much it may differ.
struct Expectation {
  /// Variance of each component of its motion [m²].
  double motion_variance = 0.0;
  /// Probability that it is seen in a cloud at all.
  double seen_share = 1.0;
  /// Largest difference, in standard deviations.
  double gate = 0.0;
};

}  // namespace quadrille
