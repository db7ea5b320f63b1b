#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// The values of successive samples as columns, for loops that become vector instructions.
struct SampleRows {
  int size;
  const float *x, *y, *z, *nx, *ny, *nz, *sigma, *cell;
};

/// Some samples, with each of these values in a row.
class SampleTable {
 public:
  SampleTable() = default;
  SampleTable(const SurfaceSamples& samples, std::span<const int> list);

  /// The samples from place `first` of the list on.
  SampleRows rows(int first, int size) const;
  /// All samples of the list.
  SampleRows rows() const { return rows(0, static_cast<int>(size_)); }

 private:
  std::size_t size_ = 0, stride_ = 0;
  std::vector<float> values_;
};

/// Sorts the samples into blocks that are near each other, with their values one after another,
/// to find those in a box with few steps. SampleBuckets has only their numbers, for those in a
/// ball.
class SampleBlocks {
 public:
  explicit SampleBlocks(const SurfaceSamples& samples);

  /// Returns all samples whose raw positions lie in a box, and perhaps some so close to it that
  /// only rounding tells, in no particular order.
  /// @param X_BC  map from frame C to the frame of the box, which may scale
  std::vector<int> in_box(const Eigen::Affine3f& X_BC, const Eigen::AlignedBox3f& box_B) const;

  /// Returns the samples of all blocks that reach into the box, of which many lie outside of it.
  std::vector<SampleRows> near_box(const Eigen::Affine3f& X_BC,
                                   const Eigen::AlignedBox3f& box_B) const;

 private:
  /// The samples first … first + size - 1 in the order of the blocks, which lie in a ball.
  struct Block {
    Eigen::Vector3f centre;
    float radius;
    int first, size;
  };

  std::vector<const Block*> blocks_near(const Eigen::Affine3f& X_BC,
                                        const Eigen::AlignedBox3f& box_B) const;

  std::vector<Block> blocks_;
  /// The samples and their indices, in the order of the blocks.
  SampleTable table_;
  std::vector<int> sample_;
};

}  // namespace quadrille
