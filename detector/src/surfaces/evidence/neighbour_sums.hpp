#pragma once

#include <span>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Sums over the pairs of neighbours within a region; each pair counts in both directions.
struct NeighbourSums {
  int pairs = 0;
  /// Sum of the products of the neighbours' distances from a quadric, and of their squared
  /// differences [m²].
  double product = 0.0, difference = 0.0;
};

/// Sums over the pairs of neighbours.
/// @param inside    per sample, nonzero if it belongs to the region
/// @param distance  per sample, its distance from the quadric [m]; read only inside the region
NeighbourSums sum_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                             const std::vector<char>& inside, const float* distance);

}  // namespace quadrille
