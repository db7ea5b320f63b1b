#include "samples/sample_buckets.hpp"

namespace quadrille {
namespace {

/// Edge of a bucket: five cells of a sample, so that few lie around a ball of some cells.
float edge_for(const SurfaceSamples& samples) {
  return samples.size() == 0 ? 1.0f : 5.0f * samples.cell[samples.size() / 2];
}

}  // namespace

SampleBuckets::SampleBuckets(const SurfaceSamples& samples)
    : SampleBuckets(samples.raw, edge_for(samples)) {}

SampleBuckets::SampleBuckets(std::span<const Eigen::Vector3f> places, float edge)
    : SampleBuckets(places, edge, std::vector<int>()) {}

SampleBuckets::SampleBuckets(std::span<const Eigen::Vector3f> places, float edge,
                             std::vector<int> bucket)
    : grid_(places, {}, edge, &bucket), samples_(sort_into_buckets(bucket, grid_.size())) {}

std::vector<int> SampleBuckets::near(const Eigen::Vector3f& centre, float radius) const {
  return NearSamples(*this, radius).around(centre);
}

// A sample is no farther from the mean of its bucket than the bucket's diagonal, √3 edges.
NearSamples::NearSamples(const SampleBuckets& buckets, float radius)
    : buckets_(buckets), finder_(buckets.grid_, radius + 2.0f * buckets.grid_.edge()) {}

const std::vector<int>& NearSamples::around(const Eigen::Vector3f& centre) {
  found_.clear();
  for (const int v : finder_.within(centre)) {
    const auto& bucket = buckets_.samples_[v];
    found_.insert(found_.end(), bucket.begin(), bucket.end());
  }
  return found_;
}

}  // namespace quadrille
