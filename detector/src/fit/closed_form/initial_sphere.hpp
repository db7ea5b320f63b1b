#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits a sphere in closed form by linear least squares of |x|² + 2 b·x + j = 0.
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_sphere(const PointMoments& moments);

}  // namespace quadrille
