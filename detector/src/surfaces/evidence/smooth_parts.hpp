#pragma once

#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Least cosine between neighbouring normals on a smoothly continuing surface (30°).
inline constexpr float kMinSmoothCosine = 0.87f;

/// Divides the samples into connected parts, cut at creases and depth edges.
class SmoothParts {
 public:
  explicit SmoothParts(const SurfaceSamples& samples);

  /// Number of the part to which a sample belongs.
  int part_of(int sample) const { return part_[sample]; }
  int size() const { return size_; }

 private:
  std::vector<int> part_;
  int size_ = 0;
};

}  // namespace quadrille
