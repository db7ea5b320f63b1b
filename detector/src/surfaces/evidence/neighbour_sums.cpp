#include "surfaces/evidence/neighbour_sums.hpp"

namespace quadrille {

NeighbourSums sum_neighbours(const SurfaceSamples& samples, std::span<const int> region,
                             const std::vector<char>& inside, const float* distance) {
  NeighbourSums sums;
  for (const int i : region) {
    const float d_i = distance[i];
    for (const int j : samples.neighbours_of(i)) {
      if (!inside[j]) continue;
      const float d_j = distance[j];
      sums.product += static_cast<double>(d_i * d_j);
      sums.difference += static_cast<double>((d_i - d_j) * (d_i - d_j));
      ++sums.pairs;
    }
  }
  return sums;
}

}  // namespace quadrille
