#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace quadrille::scene {

/// Random numbers of a (seed, stream) pair: SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
///
/// All mappings use +, -, *, / and square roots only, which IEEE 754 rounds alike everywhere, so
/// that a seed means the same scene on every machine.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : state_(mix(seed) ^ mix(~stream)) {}

  std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15u); }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in low … high, both included.
  int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
  bool chance(double probability) { return uniform() < probability; }

  /// Mean 0, variance 1, nearly normal: the sum of twelve uniforms (never beyond 6).
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  /// A uniformly distributed unit vector of the plane: cosine and sine of a random angle.
  Eigen::Vector2d direction() {
    for (;;) {
      const Eigen::Vector2d v(uniform(-1.0, 1.0), uniform(-1.0, 1.0));
      const double square = v.x() * v.x() + v.y() * v.y();
      if (square <= 1.0 && square > 1e-4) return v / std::sqrt(square);
    }
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace quadrille::scene
