#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct CompactFitOptions {
  /// w, the weight of a normal's rows relative to a point's row, in normalised coordinates. The
  /// paper gives no value.
  double weight = 1.0;
};

/// Least squares of the compact system with one common gradient scale (paper, eq. 5). It is exact
/// if the normals have the lengths of the gradients, as unit normals do up to a common factor on
/// spheres and circular cylinders.
///
/// For many points with unit normals this is Tasdizen's gradient-one fit without its ridge, since
/// |∇f − n|² = (n·∇f − 1)² + |t·∇f|².
/// @param points  at least 4; the lengths of the normals are the gradients' up to a common factor
/// @return nullopt if the points are too few, coplanar, or do not determine ten coefficients
std::optional<Quadric> fit_compact(const OrientedPointsd& points,
                                   const CompactFitOptions& options = {});

}  // namespace quadrille
