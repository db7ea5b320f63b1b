#pragma once

#include <optional>
#include <span>
#include <vector>

#include "surfaces/surface.hpp"

namespace quadrille {

/// The samples of a surface by the side from which it was seen: up the gradient of its quadric, or
/// down.
struct SeenSides {
  std::vector<int> up, down;
};

SeenSides sides_of(const Quadric& Q, const SurfaceSamples& samples, std::span<const int> region);

/// The thickness of a wall that was seen from both sides, such as a mug's.
struct MeasuredThickness {
  /// Thickness and its standard deviation [m].
  double value, std;
};

/// Measures how far the two sides of a surface are apart, which one quadric was fitted to.
///
/// Such a fit hides the thickness: if it lies nearer to the viewer by half of it, it meets the
/// middle of both walls, and misses only their flanks. So the quadric has to move as it is
/// measured: the side seen down the gradient lies at d = −t for distances d along the gradient, and
/// Gauss-Newton steps minimise Σ d² + Σ (d + t)² over the parameters θ and t, each sum over one
/// side. First-order distances will not do: t is determined so weakly that their error d²/2R takes
/// 8 mm off a wall of 3 mm at a noise of 2 mm. The variance of t is that of the residuals times the
/// last diagonal element of (JᵀJ)⁻¹, J = dr/d(θ, t), times the number of samples for each
/// independent one.
/// @return nullopt if the samples do not determine t, or if the surface was seen from one side
std::optional<MeasuredThickness> wall_thickness(const Surface& surface,
                                                const SurfaceSamples& samples,
                                                const SeenSides& sides);

}  // namespace quadrille
