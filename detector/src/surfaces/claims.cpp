#include "surfaces/claims.hpp"

#include <algorithm>
#include <iterator>

namespace quadrille {

Claims::Claims(const SurfaceSamples& samples)
    : parts_(std::make_shared<SmoothParts>(samples)),
      free_(static_cast<std::size_t>(samples.size()), 1),
      open_(static_cast<std::size_t>(parts_->size()), 0) {
  for (int i = 0; i < samples.size(); ++i) ++open_[parts_->part_of(i)];
}

void Claims::add(std::span<const int> region) {
  for (const int i : region) {
    open_[parts_->part_of(i)] -= free_[i];
    free_[i] = 0;
  }
}

std::vector<int> Claims::open_of(std::span<const int> region) const {
  std::vector<int> open;
  std::copy_if(region.begin(), region.end(), std::back_inserter(open),
               [&](int i) { return free_[i]; });
  return open;
}

double Claims::remainder(std::span<const int> region) const {
  std::vector<int> within(open_.size(), 0), open(within);
  for (const int i : region) {
    ++within[parts_->part_of(i)];
    open[parts_->part_of(i)] += free_[i];
  }
  double sum = 0;
  for (std::size_t c = 0; c < open_.size(); ++c) {
    sum += static_cast<double>(open_[c] - open[c]) * within[c];
  }
  const double n = static_cast<double>(region.size());
  return sum / (n * n);
}

}  // namespace quadrille
