#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Sorts the samples into blocks that are near each other, with their positions one after another,
/// to find those in a box with few steps.
class SampleBlocks {
 public:
  explicit SampleBlocks(const SurfaceSamples& samples);

  /// Returns all samples whose raw positions lie in a box, and perhaps some so close to it that
  /// only rounding tells, in no particular order.
  /// @param X_BC  map from frame C to the frame of the box, which may scale
  std::vector<int> in_box(const Eigen::Affine3f& X_BC, const Eigen::AlignedBox3f& box_B) const;

 private:
  /// The samples first … first + size - 1 in the order of the blocks, which lie in a ball.
  struct Block {
    Eigen::Vector3f centre;
    float radius;
    int first, size;
  };

  std::vector<Block> blocks_;
  /// Positions of the samples [m] and their indices, in the order of the blocks.
  std::vector<float> x_, y_, z_;
  std::vector<int> sample_;
};

}  // namespace quadrille
