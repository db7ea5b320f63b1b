#include "samples/sample_buckets.hpp"

#include "samples/voxel/voxel_finder.hpp"

namespace quadrille {
namespace {

/// Edge of a bucket: five cells of a sample, so that few lie around a ball of some cells.
float edge_for(const SurfaceSamples& samples) {
  return samples.size() == 0 ? 1.0f : 5.0f * samples.cell[samples.size() / 2];
}

}  // namespace

SampleBuckets::SampleBuckets(const SurfaceSamples& samples)
    : SampleBuckets(samples, edge_for(samples)) {}

SampleBuckets::SampleBuckets(const SurfaceSamples& samples, float edge)
    : SampleBuckets(samples, edge, std::vector<int>()) {}

SampleBuckets::SampleBuckets(const SurfaceSamples& samples, float edge, std::vector<int> bucket)
    : grid_(samples.raw, {}, edge, &bucket), samples_(sort_into_buckets(bucket, grid_.size())) {}

std::vector<int> SampleBuckets::near(const Eigen::Vector3f& centre, float radius) const {
  // A sample is no farther from the mean of its bucket than the bucket's diagonal, √3 edges.
  VoxelFinder finder(grid_, radius + 2.0f * grid_.edge());
  std::vector<int> found;
  for (const int v : finder.within(centre)) {
    found.insert(found.end(), samples_[v].begin(), samples_[v].end());
  }
  return found;
}

}  // namespace quadrille
