#include "lab/bench/floor.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "samples/cell_pyramid.hpp"

namespace quadrille::bench {

WorksOn works_on(std::string_view stage) {
  constexpr std::array<std::string_view, 3> kOnPoints = {"cells", "measure", "boxes"};
  const bool on_points = std::find(kOnPoints.begin(), kOnPoints.end(), stage) != kOnPoints.end();
  return on_points ? WorksOn::kPoints : WorksOn::kSamples;
}

SurfaceSamples finest_samples(const PointCloud& cloud, const DetectorOptions& options) {
  const auto pyramid = make_pyramid(cloud, options.sampling);
  if (!pyramid) return {};
  const Mask all(static_cast<std::size_t>(pyramid->size(0)), 1);
  std::vector<SurfaceSamples> levels = pyramid->samples(all, options.threads);
  return std::move(levels.front());
}

float pass_over(std::span<const Eigen::Vector3f> positions) {
  // Several points at a time, such that the sums become vectors and do not wait for each other.
  constexpr int kStrands = 24;
  const auto coordinates =
      Eigen::Map<const Eigen::ArrayXf>(positions.empty() ? nullptr : positions.front().data(),
                                       3 * static_cast<Eigen::Index>(positions.size()));
  Eigen::Array<float, kStrands, 1> sums = Eigen::Array<float, kStrands, 1>::Zero();
  const Eigen::Index whole = coordinates.size() / kStrands * kStrands;
  for (Eigen::Index k = 0; k < whole; k += kStrands) sums += coordinates.segment<kStrands>(k);
  return sums.sum() + coordinates.tail(coordinates.size() - whole).sum();
}

float pass_over(const SurfaceSamples& samples) {
  return pass_over(samples.p) + pass_over(samples.n);
}

}  // namespace quadrille::bench
