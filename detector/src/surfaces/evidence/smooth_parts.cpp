#include "surfaces/evidence/smooth_parts.hpp"

#include "samples/flood.hpp"

namespace quadrille {

SmoothParts::SmoothParts(const SurfaceSamples& samples)
    : part_(static_cast<std::size_t>(samples.size()), -1) {
  for (int seed = 0; seed < samples.size(); ++seed) {
    if (part_[seed] >= 0) continue;
    part_[seed] = size_;
    flood(samples, {seed}, [&](int j, int i) {
      if (part_[j] >= 0 || samples.n[j].dot(samples.n[i]) < kMinSmoothCosine) return false;
      part_[j] = size_;
      return true;
    });
    ++size_;
  }
}

}  // namespace quadrille
