#pragma once

#include <optional>

#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"

namespace quadrille {

/// A circular cone of one nappe in closed form: axis at a constant angle to all normals, apex where
/// all tangent planes meet.
/// @return nullopt where the points do not determine the surface
std::optional<PosedQuadric> initial_cone(const OrientedPointsf& points);

}  // namespace quadrille
