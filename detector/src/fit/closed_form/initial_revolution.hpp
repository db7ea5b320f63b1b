#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits a quadric of revolution in closed form: axis_of_revolution(), then by linear least squares
/// the profile
///   ρ² = α + β s + γ s².
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_revolution(const PointMoments& moments);

}  // namespace quadrille
