#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// Taubin's fit, the detector's own (fit/taubin.hpp), in double precision and with a check that no
/// other quadric fits as well.
/// @param points  9 or more; normals only choose the gradient's side
/// @return nullopt if the points are too few, coplanar, or lie on another quadric as well
std::optional<Quadric> fit_taubin(const OrientedPointsd& points);

}  // namespace quadrille
