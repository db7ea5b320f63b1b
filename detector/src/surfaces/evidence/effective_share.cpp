#include "surfaces/evidence/effective_share.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "samples/inliers.hpp"
#include "surfaces/evidence/neighbour_sums.hpp"

namespace quadrille {
namespace {

// Upper limit of the correlation, so that fully correlated residuals, such as those of a wrong
// quadric, still leave some information.
constexpr double kMaxCorrelation = 0.98;

}  // namespace

double effective_share(double correlation) {
  const double rho = std::clamp(correlation, 0.0, kMaxCorrelation);
  const double ratio = (1 - rho) / (1 + rho);
  return ratio * ratio;
}

double effective_share(const SurfaceSamples& samples, std::span<const int> region,
                       const Quadric& quadric) {
  const Eigen::Matrix4f Q = quadric.normalized().matrix().cast<float>();
  const std::size_t size = static_cast<std::size_t>(samples.size());
  // Only the region's residuals are set and read; clearing all would take longer than the sums.
  const auto residual = std::make_unique_for_overwrite<float[]>(size);
  std::vector<char> inside(size, 0);
  double square = 0;
  for (const int i : region) {
    residual[i] = distance_to(Q, samples.raw[i]);
    inside[i] = 1;
    square += residual[i] * residual[i];
  }
  const NeighbourSums sums = sum_neighbours(samples, region, inside, residual.get());
  if (sums.pairs == 0 || !(square > 0)) return 1.0;
  const double variance = square / static_cast<double>(region.size());
  return effective_share(sums.product / (sums.pairs * variance));
}

}  // namespace quadrille
