#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Any quadric in closed form: Taubin's fit (taubin.hpp).
/// @return nullopt where the points do not determine the surface
std::optional<PosedQuadric> initial_general(const OrientedPointsf& points);

}  // namespace quadrille
