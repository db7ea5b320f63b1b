#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// Fits a circular cone to three oriented points (paper, figure 2b: nothing to vote for). Its
/// tangent planes meet in the apex p, nᵢ·(p − xᵢ) = 0, and all normals make one angle with the
/// axis, nᵢ·a = ∓sin α, where a points towards the nappe of the points and − holds if the normals
/// point outwards.
/// @return symmetric 4x4 matrix with its gradient on the side of the normals; nullopt if the
///   normals lie nearly in a plane, or the points on both nappes
std::optional<Eigen::Matrix4d> cone_through(const std::array<OrientedPoint, 3>& basis);

}  // namespace quadrille
