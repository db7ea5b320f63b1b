#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille {

/// The k-th of the values in ascending order, from 0. Reorders them; there must be more than k.
template <class Value>
Value nth_smallest(std::vector<Value>& values, std::size_t k) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(k);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The value that a share of the others, 0 to 1, do not exceed; of two the lower one. Reorders the
/// values, of which there must be one.
template <class Value>
Value quantile(std::vector<Value>& values, double share) {
  return nth_smallest(values,
                      static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// The value in the middle; of two the upper one. Reorders the values, of which there must be one.
template <class Value>
Value median(std::vector<Value>& values) {
  return nth_smallest(values, values.size() / 2);
}

}  // namespace quadrille
