#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/depth/depth_cells.hpp"

namespace quadrille {

/// No depth camera has less noise [m]; less is rounding, or a generated cloud without noise.
inline constexpr float kMinSigma = 1e-4f;
/// Least number of residuals for which a quantile is meaningful.
inline constexpr std::size_t kMinResiduals = 8;

/// Noise of cell means around the true surface, which grows with depth: sigma(z) = factor ·
/// z^exponent [m].
struct NoiseModel {
  double factor = 0.001;
  double exponent = 2.0;
  /// Standard deviation along the ray at depth z [m].
  float sigma(float z) const;
};

/// Measures the noise of cell means at each level of a pyramid, as the residual of quadratic
/// patches (w is a quadratic in (u, v)) that are fitted on the second level.
/// @param levels  finest first, each with twice the cell edge of the one before
/// @return one model per level
std::vector<NoiseModel> measure_noise(std::span<const DepthCells> levels,
                                      const NoiseOptions& options);

/// Share of a finest cell's noise, 0 to 1, that its neighbourhood has in common, from the noise of
/// the finest and of the coarsest level. White noise halves from level to level, so that almost
/// none remains; the waves of a real sensor remain, and bend whole surfaces.
double common_share(double finest_sigma, double coarsest_sigma);

}  // namespace quadrille
