#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// Fits a circular cylinder to two oriented points (paper, figure 2b: nothing to vote for). Both
/// normals meet the axis at right angles, u ∥ n₁ × n₂. In the plane across u the positions are yᵢ =
/// c + r nᵢ, four equations for three unknowns, with the least-squares solution r = (y₁ − y₂)·(n₁ −
/// n₂) / |n₁ − n₂|², which is exact for exact points and negative if the normals point inwards.
/// @return symmetric 4x4 matrix with its gradient on the side of the normals; nullopt if the
///   normals are within about 10° of parallel or opposite
std::optional<Eigen::Matrix4d> cylinder_through(const std::array<OrientedPoint, 2>& basis);

}  // namespace quadrille
