#pragma once

#include <vector>

#include "quadrille/detector/depth_cells.hpp"

namespace quadrille {

/// Noise of cell means about the true surface, as it grows with depth:
/// sigma(z) = factor · z^exponent [m].
struct NoiseModel {
  double factor = 0.001;
  double exponent = 2.0;
  /// Standard deviation along the ray at depth z [m].
  float sigma(float z) const;
};

/// Measures the noise of cell means as the residual of quadratic patches, w = quadratic in (u, v),
/// of the given radius. Windows smaller than the waves of a sensor's correlated noise would follow
/// the waves and see too little of them; of all patches a low quantile is taken, because clutter
/// is no quadratic.
/// @param radius  of the patches [m]
NoiseModel measure_noise(const DepthCells& cells, double radius, double quantile);

}  // namespace quadrille
