#pragma once

#include <optional>

#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Starts for special surfaces of revolution, made from a general one whose points lie around z = 0
/// of its frame. Each is nullopt if no such surface is near it.

/// The paraboloid with the same profile ρ² = α + β s + γ s², but γ = 0.
std::optional<PosedQuadric> initial_paraboloid(const PosedQuadric& revolution);
/// The cone or cylinder that touches the surface at z = 0.
std::optional<PosedQuadric> tangent_cone(const PosedQuadric& revolution);
std::optional<PosedQuadric> tangent_cylinder(const PosedQuadric& revolution);

}  // namespace quadrille
