#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct TangentFitOptions {
  /// Weight of a tangent constraint relative to a point, in normalised coordinates.
  double weight = 1.0;
};

/// The full system with its scales eliminated (paper, eq. 4 with αᵢ = nᵢ·∇f): least squares of
/// f(xᵢ) = 0 and of both tangent constraints t·∇f(xᵢ) = 0, under Taubin's constraint that the
/// squared gradient has mean 1. This constraint turns residuals into lengths and angles. The
/// constraint on |q| in fit_full() does not, which makes that fit unstable under noise.
/// @param points  at least 4
/// @return nullopt if the points are too few, coplanar, or admit another solution
std::optional<Quadric> fit_tangent(const OrientedPointsd& points,
                                   const TangentFitOptions& options = {});

}  // namespace quadrille
