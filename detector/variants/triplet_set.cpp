#include "variants/triplet_set.hpp"

#include <algorithm>

#include "base/random.hpp"

namespace quadrille {

bool TripletSet::insert(std::array<int, 3> triplet) {
  std::sort(triplet.begin(), triplet.end());
  const bool is_new = triplets_.insert(triplet).second;
  repeats_ += !is_new;
  return is_new;
}

std::size_t TripletSet::Hash::operator()(const std::array<int, 3>& triplet) const {
  const auto part = [&](std::size_t k) { return static_cast<std::uint64_t>(triplet[k]); };
  // The random stream's mixing of seed and trial serves as a hash of two numbers.
  return RandomStream(part(0) << 32 | part(1), part(2)).next();
}

}  // namespace quadrille
