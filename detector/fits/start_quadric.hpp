#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// The best start for an iterative fit in normalised coordinates: the most likely of the
/// closed-form fits to the points (Taubin, tangent, compact), with unknown noise of points and
/// normals.
/// @return nullopt if none of them has a solution
std::optional<Quadric> start_quadric(const OrientedPointsd& normalised);

}  // namespace quadrille
