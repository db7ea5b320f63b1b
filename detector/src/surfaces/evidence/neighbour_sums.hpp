#pragma once

#include <span>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Sums over the pairs of neighbours within a region, each pair from both sides.
struct NeighbourSums {
  int pairs = 0;
  /// Of the products of their distances from a quadric, and of the squared differences [m²].
  double product = 0.0, difference = 0.0;
};

/// @param inside    per sample, nonzero for those of the region
/// @param distance  per sample, its distance from the quadric [m]
NeighbourSums sum_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                             const std::vector<char>& inside, const std::vector<float>& distance);

}  // namespace quadrille
