#include "surfaces/evidence/smooth_parts.hpp"

namespace quadrille {

SmoothParts::SmoothParts(const SurfaceSamples& samples)
    : part_(static_cast<std::size_t>(samples.size()), -1) {
  std::vector<int> list;
  for (int seed = 0; seed < samples.size(); ++seed) {
    if (part_[seed] >= 0) continue;
    part_[seed] = size_;
    list.assign(1, seed);
    for (std::size_t k = 0; k < list.size(); ++k) {
      for (const int j : samples.neighbours_of(list[k])) {
        if (part_[j] >= 0 || samples.n[j].dot(samples.n[list[k]]) < kMinSmoothCosine) continue;
        part_[j] = size_;
        list.push_back(j);
      }
    }
    ++size_;
  }
}

}  // namespace quadrille
