#pragma once

#include <Eigen/Core>
#include <cmath>

#include "base/random.hpp"

namespace quadrille::scene {

/// The detector's random number stream, mapped to the distributions from which scenes are drawn.
///
/// All mappings use only +, -, *, / and square roots, which IEEE 754 rounds alike everywhere, so
/// that a seed means the same scene on every machine.
class Random : public RandomStream {
 public:
  using RandomStream::RandomStream;
  using RandomStream::uniform;

  /// Returns a number uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Returns an integer uniform in low … high, both included.
  int integer(int low, int high) { return low + below(high - low + 1); }
  bool chance(double probability) { return uniform() < probability; }

  /// Returns a nearly normal number with mean 0 and variance 1: the sum of twelve uniform ones
  /// (never beyond 6).
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  /// Returns a uniformly distributed unit vector of the plane: cosine and sine of a random angle.
  Eigen::Vector2d direction() {
    for (;;) {
      const Eigen::Vector2d v(uniform(-1.0, 1.0), uniform(-1.0, 1.0));
      const double square = v.x() * v.x() + v.y() * v.y();
      if (square <= 1.0 && square > 1e-4) return v / std::sqrt(square);
    }
  }
};

}  // namespace quadrille::scene
