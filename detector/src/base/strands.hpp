#pragma once

#include "base/vector_clones.hpp"

namespace quadrille {

/// Eight partial sums side by side: for floats one AVX register, or two SSE registers.
template <typename Scalar>
struct StrandsOf;
template <>
struct StrandsOf<float> {
  using Type __attribute__((vector_size(kLanes * sizeof(float)), may_alias)) = float;
};
template <>
struct StrandsOf<double> {
  using Type __attribute__((vector_size(kLanes * sizeof(double)), may_alias)) = double;
};

/// The sum of all strands.
template <typename Strands>
QUADRILLE_INTO_CLONES double sum_of_strands(const Strands& s) {
  return static_cast<double>((s[0] + s[4]) + (s[1] + s[5]) + ((s[2] + s[6]) + (s[3] + s[7])));
}

}  // namespace quadrille
