#pragma once

#include <optional>

#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Starts for special surfaces of revolution from a general one, which lies about z = 0 of its
/// frame. Each is nullopt where the general one has no such surface near it.

/// The paraboloid: the same profile ρ² = α + β s + γ s² with γ = 0.
std::optional<PosedQuadric> initial_paraboloid(const PosedQuadric& revolution);
/// Cone and cylinder that touch it at z = 0.
std::optional<PosedQuadric> tangent_cone(const PosedQuadric& revolution);
std::optional<PosedQuadric> tangent_cylinder(const PosedQuadric& revolution);

}  // namespace quadrille
