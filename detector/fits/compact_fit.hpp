#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct CompactFitOptions {
  /// w, the weight of a normal's rows against a point's row, in normalised coordinates. The paper
  /// names it without a value.
  double weight = 1.0;
};

/// Least squares of the compact system with one common gradient scale (paper, eq. 5): exact where
/// the normals have the lengths of the gradients, as all have on spheres and circular cylinders.
///
/// Over many points with unit normals this is Tasdizen's gradient-one fit without its ridge, as
/// |∇f − n|² = (n·∇f − 1)² + |t·∇f|².
/// @param points  4 or more; normals' lengths are taken as the gradient's up to a common factor
/// @return nullopt if the points are too few, coplanar, or do not determine ten coefficients
std::optional<Quadric> fit_compact(const OrientedPointsd& points,
                                   const CompactFitOptions& options = {});

}  // namespace quadrille
