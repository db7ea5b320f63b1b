#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille {

/// Returns the k-th smallest value, counted from 0. Reorders the values, of which there must be
/// more than k.
template <class Value>
Value nth_smallest(std::vector<Value>& values, std::size_t k) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(k);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns the value that a given share, 0 to 1, of the others does not exceed; between two values,
/// the lower. Reorders the values, which must not be empty.
template <class Value>
Value quantile(std::vector<Value>& values, double share) {
  return nth_smallest(values,
                      static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// Returns the median; of the two middle values, the upper one. Reorders the values, which must not
/// be empty.
template <class Value>
Value median(std::vector<Value>& values) {
  return nth_smallest(values, values.size() / 2);
}

/// Returns the standard deviation of normal noise from the median of its absolute values. Reorders
/// the values, which must not be empty.
template <class Value>
Value robust_std(std::vector<Value>& values) {
  for (Value& value : values) value = std::abs(value);
  return Value(1.4826) * median(values);
}

}  // namespace quadrille
