#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// A sphere in closed form: linear least squares of |x|² + 2 b·x + j = 0.
/// @return nullopt where the points do not determine the surface
std::optional<PosedQuadric> initial_sphere(const OrientedPointsf& points);

}  // namespace quadrille
