#include "samples/sample_buckets.hpp"

#include "samples/voxel/voxel_finder.hpp"

namespace quadrille {
namespace {

// Edge of a bucket in cells of a sample; a surface then fills some dozens of buckets.
constexpr float kEdgeCells = 12.0f;
// Arbitrary edge if there are no samples [m].
constexpr float kDefaultEdge = 0.05f;
// Ratio of a bucket's diagonal to its edge, rounded up.
constexpr float kDiagonal = 1.7321f;

float edge_for(const SurfaceSamples& samples) {
  return samples.size() == 0 ? kDefaultEdge : kEdgeCells * samples.cell[samples.size() / 2];
}

}  // namespace

SampleBuckets::SampleBuckets(const SurfaceSamples& samples)
    : SampleBuckets(samples, std::vector<int>()) {}

SampleBuckets::SampleBuckets(const SurfaceSamples& samples, std::vector<int> bucket)
    : grid_(samples.raw, {}, edge_for(samples), &bucket) {
  first_.assign(static_cast<std::size_t>(grid_.size()) + 1, 0);
  // Samples that are not finite lie in no bucket.
  for (const int v : bucket) {
    if (v >= 0) ++first_[v + 1];
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  list_.assign(static_cast<std::size_t>(first_.back()), 0);
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    if (bucket[i] >= 0) list_[next[bucket[i]]++] = static_cast<int>(i);
  }
}

std::vector<int> SampleBuckets::near(const Eigen::Vector3f& centre, float radius) const {
  // A sample is no farther from the mean of its bucket than the bucket's diagonal.
  VoxelFinder finder(grid_, radius + kDiagonal * grid_.edge());
  std::vector<int> found;
  for (const int v : finder.within(centre)) {
    found.insert(found.end(), list_.begin() + first_[v], list_.begin() + first_[v + 1]);
  }
  return found;
}

}  // namespace quadrille
