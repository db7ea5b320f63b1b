#pragma once

#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Where the normals of neighbours turn by less than this, 30°, the surface goes on smoothly: least
/// cosine between them.
inline constexpr float kMinSmoothCosine = 0.87f;

/// The samples in connected parts, cut at creases and depth edges.
class SmoothParts {
 public:
  explicit SmoothParts(const SurfaceSamples& samples);

  /// Number of the part that a sample belongs to.
  int part_of(int sample) const { return part_[sample]; }
  int size() const { return size_; }

 private:
  std::vector<int> part_;
  int size_ = 0;
};

}  // namespace quadrille
