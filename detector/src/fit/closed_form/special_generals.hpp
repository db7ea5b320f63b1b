#pragma once

#include <optional>

#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Starts for quadrics with two principal directions, made from a quadric with three by setting its
/// least eigenvalue to zero. Each is nullopt if no such surface is nearby.

/// The paraboloid λ₁x² + λ₂y² + 2z = 0 in the frame of its vertex.
std::optional<PosedQuadric> nearest_parabolic(const PosedQuadric& general);
/// The cylinder λ₁x² + λ₂y² - 1 = 0 in the frame of its axis, without a linear part along it.
std::optional<PosedQuadric> nearest_cylindrical(const PosedQuadric& general);

}  // namespace quadrille
