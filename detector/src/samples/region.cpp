#include "samples/region.hpp"

#include <algorithm>
#include <cstdint>

namespace quadrille {
namespace {

// A region that is smaller [m] is a point.
constexpr double kMinRadius = 1e-6;

/// The k-th of a golden-ratio sequence over 0 … n-1: even, and in step with no grid, where every
/// m-th element of a region could be the same few columns.
std::size_t golden_index(std::size_t k, std::size_t n) {
  const std::uint64_t fraction = (k + 1) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>((fraction >> 32) * n >> 32);
}

}  // namespace

std::vector<int> spread_evenly(std::span<const int> region, std::size_t most) {
  if (region.size() <= most) return {region.begin(), region.end()};
  std::vector<int> some(most);
  for (std::size_t k = 0; k < most; ++k) some[k] = region[golden_index(k, region.size())];
  return some;
}

Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region) {
  if (region.empty()) return {};
  Normalisation result = normalisation_about_centroid(
      region.size(), Radius::kRootMeanSquare,
      [&](std::size_t k) { return samples.raw[region[k]].cast<double>(); });
  result.scale = std::max(kMinRadius, result.scale);
  return result;
}

OrientedPointsf fit_points(const SurfaceSamples& samples, std::span<const int> region,
                           const Normalisation& normalisation, int most) {
  const std::size_t size = std::min<std::size_t>(region.size(), most);
  OrientedPointsf points(static_cast<Eigen::Index>(size));
  const Eigen::Vector3f centre = normalisation.centre.cast<float>();
  const float inverse = static_cast<float>(1.0 / normalisation.scale);
  for (std::size_t k = 0; k < size; ++k) {
    const int i = region[size == region.size() ? k : golden_index(k, region.size())];
    points.points.col(static_cast<Eigen::Index>(k)) = (samples.raw[i] - centre) * inverse;
    points.normals.col(static_cast<Eigen::Index>(k)) = samples.n[i];
  }
  return points;
}

}  // namespace quadrille
