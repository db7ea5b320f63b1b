#pragma once

#include <Eigen/Core>
#include <vector>

#include "samples/surface_samples.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// The samples sorted into wide voxels, to find those of a ball without looking at all.
class SampleBuckets {
 public:
  explicit SampleBuckets(const SurfaceSamples& samples);

  /// All samples whose raw positions lie within the radius [m] of the centre, and some around, in
  /// no particular order.
  std::vector<int> near(const Eigen::Vector3f& centre, float radius) const;

 private:
  /// @param bucket  room for the voxel of each sample
  SampleBuckets(const SurfaceSamples& samples, std::vector<int> bucket);

  VoxelGrid grid_;
  /// Samples of voxel v: list_[first_[v]] … list_[first_[v + 1] - 1].
  std::vector<int> first_, list_;
};

}  // namespace quadrille
