#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct TangentFitOptions {
  /// Weight of a tangent constraint against a point, in normalised coordinates.
  double weight = 1.0;
};

/// The full system with its scales eliminated (paper, eq. 4 with αᵢ = nᵢ·∇f): least squares of
/// f(xᵢ) = 0 and of both tangent constraints t·∇f(xᵢ) = 0, under Taubin's constraint that the
/// squared gradient has mean 1. The constraint makes residuals lengths and angles; that on |q| of
/// fit_full() makes nothing of the kind, which is why that one destabilises under noise.
/// @param points  4 or more
/// @return nullopt if the points are too few, coplanar, or admit another solution
std::optional<Quadric> fit_tangent(const OrientedPointsd& points,
                                   const TangentFitOptions& options = {});

}  // namespace quadrille
