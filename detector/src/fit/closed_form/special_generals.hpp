#pragma once

#include <optional>

#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Starts for quadrics with two principal directions from one with three, whose least eigenvalue is
/// set to zero. Each is nullopt where that leaves no such surface nearby.

/// About its vertex: λ₁x² + λ₂y² + 2z = 0.
std::optional<PosedQuadric> nearest_parabolic(const PosedQuadric& general);
/// About its axis, and without a linear part along it: λ₁x² + λ₂y² - 1 = 0.
std::optional<PosedQuadric> nearest_cylindrical(const PosedQuadric& general);

}  // namespace quadrille
