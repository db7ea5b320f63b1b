#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// A plane in closed form: centroid and direction of least spread.
/// @return nullopt where the points do not determine the surface
std::optional<PosedQuadric> initial_plane(const OrientedPointsf& points);

}  // namespace quadrille
