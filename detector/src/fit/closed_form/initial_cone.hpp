#pragma once

#include <optional>

#include "fit/closed_form/point_moments.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// Fits a circular cone of one nappe in closed form: the axis is at a constant angle to all
/// normals, and the apex lies in all tangent planes.
/// @return nullopt if the points do not determine the surface
std::optional<PosedQuadric> initial_cone(const PointMoments& moments);

}  // namespace quadrille
