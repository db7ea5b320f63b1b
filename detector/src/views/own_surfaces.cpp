#include "views/own_surfaces.hpp"

#include <algorithm>

#include "base/mask.hpp"

namespace quadrille {

OwnSurfaces::OwnSurfaces(const SurfaceSamples& samples, const std::vector<Candidate>& candidates)
    : samples_(samples) {
  for (const Candidate& candidate : candidates) {
    if (candidate.region.empty()) continue;
    const std::size_t view = samples.view_of(candidate.region.front());
    if (view >= regions_of_view_.size()) regions_of_view_.resize(view + 1);
    regions_of_view_[view].push_back(candidate.region);
  }
}

bool OwnSurfaces::tell_apart(std::span<const int> region) const {
  Mask on(static_cast<std::size_t>(samples_.size()), 0);
  for (const int i : region) on[i] = 1;
  const auto is_mostly_on = [&](const std::vector<int>& own) {
    const auto n = std::count_if(own.begin(), own.end(), [&](int i) { return on[i] != 0; });
    return 2 * n > static_cast<std::ptrdiff_t>(own.size());
  };
  return std::any_of(regions_of_view_.begin(), regions_of_view_.end(), [&](const auto& regions) {
    return std::count_if(regions.begin(), regions.end(), is_mostly_on) > 1;
  });
}

}  // namespace quadrille
