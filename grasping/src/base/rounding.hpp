#pragma once

#include <limits>

namespace quadrille {

/// Bound of the rounding errors of a few operations in single precision, as a share of the values
/// [-], or in metres within some metres of the origin.
inline constexpr float kFloatRounding = std::numeric_limits<float>::epsilon() * 16.0f;

}  // namespace quadrille
