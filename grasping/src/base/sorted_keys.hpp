#pragma once

#include <cstdint>
#include <vector>

namespace quadrille {

/// A number to sort by, and what it belongs to.
struct Keyed {
  std::uint64_t key = 0;
  int index = 0;
};

/// Sorts by keys in ascending order. Those with equal keys stay in the order that they have.
void sort_by_key(std::vector<Keyed>* keyed);

}  // namespace quadrille
