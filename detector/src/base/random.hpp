#pragma once

#include <cstdint>

namespace quadrille {

/// A stream of random numbers that depends only on (seed, trial), on every platform.
///
/// The generator is SplitMix64 (Steele, Lea, Flood, OOPSLA 2014) with a mixed initial state.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t trial)
      : state_(mix(seed + 0x9e3779b97f4a7c15u) ^ mix(trial + 0xd1b54a32d192ed03u)) {}

  /// Returns a number uniform over all 64-bit integers.
  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15u); }

  /// Returns an integer uniform over 0 … n-1, for 0 < n < 2³².
  int below(int n) {
    return static_cast<int>(((next() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
  }

  /// Returns a number uniform over [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace quadrille
