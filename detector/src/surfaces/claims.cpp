#include "surfaces/claims.hpp"

#include <algorithm>
#include <iterator>

namespace quadrille {

Claims::Claims(int samples) : free_(static_cast<std::size_t>(samples), 1) {}

void Claims::add(std::span<const int> region) {
  for (const int i : region) free_[i] = 0;
}

std::vector<int> Claims::open_of(std::span<const int> region) const {
  std::vector<int> open;
  std::copy_if(region.begin(), region.end(), std::back_inserter(open),
               [&](int i) { return free_[i]; });
  return open;
}

}  // namespace quadrille
