#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// A circular cylinder in closed form: axis across all normals (least eigenvector of Σ n nᵀ),
/// circle by linear least squares.
/// @return nullopt where the points do not determine the surface
std::optional<PosedQuadric> initial_cylinder(const OrientedPointsf& points);

}  // namespace quadrille
