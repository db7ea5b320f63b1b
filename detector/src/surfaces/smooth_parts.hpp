#pragma once

#include <span>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// The samples in connected parts, cut at creases and depth edges.
class SmoothParts {
 public:
  explicit SmoothParts(const SurfaceSamples& samples);

  /// Number of the part that a sample belongs to.
  int part_of(int sample) const { return part_[sample]; }
  int size() const { return size_; }

  /// Marks the samples as explained.
  void claim(std::span<const int> region);
  /// Per sample, nonzero if it was claimed.
  const std::vector<char>& claimed() const { return claimed_; }

  /// Samples that nothing has claimed, of the parts that a region lies in, and that it leaves over,
  /// per sample of the region; each part counts by its share of the region.
  double remainder(std::span<const int> region) const;

 private:
  std::vector<int> part_;
  std::vector<char> claimed_;
  /// Of each part, the samples that are not claimed.
  std::vector<int> open_;
  int size_ = 0;
};

}  // namespace quadrille
