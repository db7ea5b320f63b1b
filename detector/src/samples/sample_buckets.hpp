#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "samples/surface_samples.hpp"
#include "samples/voxel/voxel_finder.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Sorts samples by their raw positions into voxels, to find those in a ball without looking at all
/// of them.
class SampleBuckets {
 public:
  explicit SampleBuckets(const SurfaceSamples& samples);
  /// @param places  the positions of the samples; those that are not finite are never found [m]
  /// @param edge    of the voxels [m]
  SampleBuckets(std::span<const Eigen::Vector3f> places, float edge);

  /// The samples in an order in which those that are near each other mostly follow each other.
  const std::vector<int>& in_order() const { return samples_.list; }
  /// Returns all samples whose positions lie within the radius [m] of the centre, and some
  /// around them, in no particular order.
  std::vector<int> near(const Eigen::Vector3f& centre, float radius) const;

 private:
  friend class NearSamples;

  /// @param bucket  buffer for the voxel of each sample
  SampleBuckets(std::span<const Eigen::Vector3f> places, float edge, std::vector<int> bucket);

  VoxelGrid grid_;
  /// The samples in each voxel; those that are not finite lie in none.
  Buckets samples_;
};

/// Finds samples around one place after another, with less work if the places follow each other
/// closely.
class NearSamples {
 public:
  /// @param radius  of all balls [m]
  NearSamples(const SampleBuckets& buckets, float radius);

  /// Returns what SampleBuckets::near() does, until the next call.
  const std::vector<int>& around(const Eigen::Vector3f& centre);

 private:
  const SampleBuckets& buckets_;
  VoxelFinder finder_;
  std::vector<int> found_;
};

}  // namespace quadrille
