#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// The circular cylinder of two oriented points (paper, figure 2b: two points, nothing to vote
/// for). Both normals meet the axis at right angles, u ∥ n₁ × n₂. In the plane across u the
/// positions are yᵢ = c + r nᵢ, three unknowns in four equations: r = (y₁ − y₂)·(n₁ − n₂) / |n₁ −
/// n₂|², negative where the normals point inwards. It is the least-squares solution, and exact on
/// exact points.
/// @return symmetric 4x4 matrix, its gradient on the side of the normals; nullopt if the normals
/// are
///         within some 10° of parallel, or opposite
std::optional<Eigen::Matrix4d> cylinder_through(const std::array<OrientedPoint, 2>& basis);

}  // namespace quadrille
