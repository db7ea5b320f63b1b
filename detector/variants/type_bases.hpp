#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_point.hpp"

namespace quadrille {

/// Fits a circular cylinder to two oriented points (paper, figure 2b: nothing to vote for). Both
/// normals meet the axis at right angles, u ∥ n₁ × n₂. In the plane across u the positions are yᵢ =
/// c + r nᵢ, four equations for three unknowns, with the least-squares solution r = (y₁ − y₂)·(n₁ −
/// n₂) / |n₁ − n₂|², which is exact for exact points and negative if the normals point inwards.
/// @return symmetric 4x4 matrix with its gradient on the side of the normals; nullopt if the
///   normals are within about 10° of parallel or opposite
std::optional<Eigen::Matrix4d> cylinder_through(const std::array<OrientedPoint, 2>& basis);

/// Fits a circular cone to three oriented points (paper, figure 2b: nothing to vote for). Its
/// tangent planes meet in the apex p, nᵢ·(p − xᵢ) = 0, and all normals make one angle with the
/// axis, nᵢ·a = ∓sin α, where a points towards the nappe of the points and − holds if the normals
/// point outwards.
/// @return symmetric 4x4 matrix with its gradient on the side of the normals; nullopt if the
///   normals lie nearly in a plane, or if the points agree better with a cone of which they lie on
///   both nappes
std::optional<Eigen::Matrix4d> cone_through(const std::array<OrientedPoint, 3>& basis);

}  // namespace quadrille
