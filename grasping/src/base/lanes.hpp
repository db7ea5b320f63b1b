#pragma once

#include <cstring>

#include "quadrille/detector/vector_clones.hpp"

namespace quadrille {

// Values that loops process side by side: each of these is one AVX register, or two SSE registers.
// A comparison gives a mask, whose lanes are all ones where it holds and zero elsewhere.
inline constexpr int kFloatLanes = 8, kDoubleLanes = 4;
using FloatLanes __attribute__((vector_size(kFloatLanes * sizeof(float)), may_alias)) = float;
using FloatMasks __attribute__((vector_size(kFloatLanes * sizeof(float)), may_alias)) = int;
using DoubleLanes __attribute__((vector_size(kDoubleLanes * sizeof(double)), may_alias)) = double;
using DoubleMasks __attribute__((vector_size(kDoubleLanes * sizeof(double)), may_alias)) =
    long long;

/// Reads values, which may lie at any address.
template <class Scalar, class Lanes>
QUADRILLE_INTO_CLONES void load(const Scalar* from, Lanes& lanes) {
  static_assert(sizeof(from[0]) == sizeof(lanes[0]));
  std::memcpy(&lanes, from, sizeof(lanes));
}

/// Replaces the lanes of a mask by others.
template <class Masks, class Lanes>
QUADRILLE_INTO_CLONES void replace_in(const Masks& mask, const Lanes& others, Lanes& lanes) {
  lanes = reinterpret_cast<Lanes>((mask & reinterpret_cast<const Masks&>(others)) |
                                  (~mask & reinterpret_cast<const Masks&>(lanes)));
}

/// Sets the lanes outside of a mask to zero.
template <class Masks, class Lanes>
QUADRILLE_INTO_CLONES void clear_outside(const Masks& mask, Lanes& lanes) {
  lanes = reinterpret_cast<Lanes>(mask & reinterpret_cast<const Masks&>(lanes));
}

}  // namespace quadrille
