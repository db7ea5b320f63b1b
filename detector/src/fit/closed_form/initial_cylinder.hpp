#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits a circular cylinder in closed form: the axis is orthogonal to all normals (least
/// eigenvector of Σ n nᵀ), and the circle follows by linear least squares.
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_cylinder(const PointMoments& moments);

}  // namespace quadrille
