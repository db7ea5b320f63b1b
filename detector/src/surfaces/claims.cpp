#include "surfaces/claims.hpp"

#include <algorithm>
#include <iterator>

namespace quadrille {

Claims::Claims(int samples) : claimed_(static_cast<std::size_t>(samples), 0) {}

void Claims::add(std::span<const int> region) {
  for (const int i : region) claimed_[i] = 1;
}

std::vector<int> Claims::open_of(std::span<const int> region) const {
  std::vector<int> open;
  std::copy_if(region.begin(), region.end(), std::back_inserter(open),
               [&](int i) { return !claimed_[i]; });
  return open;
}

}  // namespace quadrille
