#include "surfaces/smooth_parts.hpp"

namespace quadrille {
namespace {

// Neighbours whose normals turn by less, 30°, belong together.
constexpr float kSmooth = 0.87f;

}  // namespace

SmoothParts::SmoothParts(const SurfaceSamples& samples)
    : part_(static_cast<std::size_t>(samples.size()), -1), claimed_(part_.size(), 0) {
  std::vector<int> list;
  for (int seed = 0; seed < samples.size(); ++seed) {
    if (part_[seed] >= 0) continue;
    part_[seed] = size_;
    list.assign(1, seed);
    for (std::size_t k = 0; k < list.size(); ++k) {
      for (const int j : samples.neighbours_of(list[k])) {
        if (part_[j] >= 0 || samples.n[j].dot(samples.n[list[k]]) < kSmooth) continue;
        part_[j] = size_;
        list.push_back(j);
      }
    }
    open_.push_back(static_cast<int>(list.size()));
    ++size_;
  }
}

void SmoothParts::claim(std::span<const int> region) {
  for (const int i : region) {
    open_[part_[i]] -= !claimed_[i];
    claimed_[i] = 1;
  }
}

double SmoothParts::remainder(std::span<const int> region) const {
  std::vector<int> within(static_cast<std::size_t>(size_), 0), open(within);
  for (const int i : region) {
    ++within[part_[i]];
    open[part_[i]] += !claimed_[i];
  }
  double sum = 0;
  for (int c = 0; c < size_; ++c) sum += static_cast<double>(open_[c] - open[c]) * within[c];
  const double n = static_cast<double>(region.size());
  return sum / (n * n);
}

}  // namespace quadrille
