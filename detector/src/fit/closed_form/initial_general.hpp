#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits any quadric in closed form by Taubin's fit (taubin.hpp).
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_general(const PointMoments& moments);

}  // namespace quadrille
