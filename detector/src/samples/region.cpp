#include "samples/region.hpp"

#include <algorithm>
#include <cstdint>

namespace quadrille {
namespace {

// Least scale [m], so that regions of one sample have a scale too.
constexpr double kMinScale = 1e-6;

/// Element k of a golden-ratio sequence over 0 … n-1. It is as even as steps of equal length, but
/// those would always hit the same few columns of a grid.
std::size_t golden_index(std::size_t k, std::size_t n) {
  const std::uint64_t fraction = (k + 1) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>((fraction >> 32) * n >> 32);
}

}  // namespace

std::vector<int> spread_evenly(std::span<const int> region, std::size_t max_count) {
  if (region.size() <= max_count) return {region.begin(), region.end()};
  std::vector<int> some(max_count);
  for (std::size_t k = 0; k < max_count; ++k) some[k] = region[golden_index(k, region.size())];
  return some;
}

Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region) {
  if (region.empty()) return {};
  Normalisation result = normalisation_about_centroid(
      region.size(), Radius::kRootMeanSquare,
      [&](std::size_t k) { return samples.raw[region[k]].cast<double>(); });
  result.scale = std::max(kMinScale, result.scale);
  return result;
}

OrientedPointsf fit_points(const SurfaceSamples& samples, std::span<const int> region,
                           const Normalisation& normalisation, int max_count) {
  const std::size_t size = std::min<std::size_t>(region.size(), max_count);
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
