#pragma once

#include "base/vector_clones.hpp"

namespace quadrille {

/// Eight partial sums side by side: for floats one AVX register, or two SSE registers.
template <typename Scalar>
struct LanesOf;
template <>
struct LanesOf<float> {
  using Type __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = float;
};
template <>
struct LanesOf<double> {
  using Type __attribute__((vector_size(kLanes * sizeof(double)), may_alias)) = double;
};

/// The sum of all lanes.
template <typename Lanes>
QUADRILLE_INTO_CLONES double sum_of_lanes(const Lanes& s) {
  return static_cast<double>((s[0] + s[4]) + (s[1] + s[5]) + ((s[2] + s[6]) + (s[3] + s[7])));
}

}  // namespace quadrille
