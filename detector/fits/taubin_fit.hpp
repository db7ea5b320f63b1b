#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// Taubin's fit as in the detector (fit/closed_form/taubin.hpp), but in double precision and with a
/// check that no other quadric fits equally well.
/// @param points  at least 9; normals only choose the gradient's side
/// @return nullopt if the points are too few, coplanar, or lie on another quadric as well
std::optional<Quadric> fit_taubin(const OrientedPointsd& points);

}  // namespace quadrille
