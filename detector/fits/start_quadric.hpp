#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// The best start for an iterative fit in normalised coordinates: among the closed-form fits to the
/// points (Taubin, tangent, compact) the likeliest, with the noise of points and of normals
/// unknown.
/// @return nullopt if none of them has a solution
std::optional<Quadric> start_quadric(const OrientedPointsd& normalised);

}  // namespace quadrille
