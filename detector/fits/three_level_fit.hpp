#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct ThreeLevelOptions {
  /// Distance of the two additional level sets from the surface, in radii of the points' ball.
  double offset = 0.05;
};

/// The 3L fit: least squares of f = 0 at the points and of f = ±δ at the points moved by ±δ along
/// their normals (M. Blane, Z. Lei, H. Civi, D. Cooper, "The 3L algorithm for fitting implicit
/// polynomial curves and surfaces to data", PAMI 2000).
/// @param points  at least 4
/// @return nullopt if the points are too few, coplanar, or do not determine ten coefficients
std::optional<Quadric> fit_three_level(const OrientedPointsd& points,
                                       const ThreeLevelOptions& options = {});

}  // namespace quadrille
