#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille {

/// The numbers 0 … n-1 sorted into buckets.
struct Buckets {
  /// Bucket b has list[first[b]] … list[first[b + 1] - 1], in ascending order.
  std::vector<int> first, list;

  int size() const { return static_cast<int>(first.size()) - 1; }
  std::span<const int> operator[](int b) const {
    return {list.data() + first[b], static_cast<std::size_t>(first[b + 1] - first[b])};
  }
};

/// Sorts numbers into buckets by counting.
/// @param bucket  for each number its bucket, less than size; negative for none
/// @param size    number of buckets
inline Buckets sort_into_buckets(std::span<const int> bucket, int size) {
  // The place after next[b] holds at first the number of values in bucket b, then where the bucket
  // begins, then, as it fills, where it ends, which is where the next one begins.
  Buckets buckets;
  buckets.first.assign(static_cast<std::size_t>(size) + 2, 0);
  int* const next = buckets.first.data() + 1;
  for (const int b : bucket) {
    if (b >= 0) ++next[b + 1];
  }
  std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
  buckets.list.resize(static_cast<std::size_t>(buckets.first.back()));
  int* const list = buckets.list.data();
  int i = 0;
  for (const int b : bucket) {
    if (b >= 0) list[next[b]++] = i;
    ++i;
  }
  buckets.first.pop_back();
  return buckets;
}

}  // namespace quadrille
