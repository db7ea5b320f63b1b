#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits any quadric in closed form by Taubin's fit (taubin.hpp).
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_general(const OrientedPointsf& points);

}  // namespace quadrille
