#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits a plane in closed form from the centroid and the direction of least spread.
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_plane(const PointMoments& moments);

}  // namespace quadrille
