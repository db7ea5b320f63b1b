#include "base/sorted_keys.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>

namespace quadrille {
namespace {

// The counts of so many digits take 8 KB, which stay in the L1 cache.
constexpr int kDigitBits = 11;
constexpr std::uint64_t kDigits = 1 << kDigitBits;
// To count digits takes longer than to sort so few keys by comparing them.
constexpr std::size_t kFew = 200;

/// Sorts by one digit of the keys, which begins at a bit.
void sort_by_digit(const std::vector<Keyed>& from, int first_bit, std::vector<Keyed>* to) {
  const auto digit = [&](const Keyed& one) { return one.key >> first_bit & (kDigits - 1); };
  std::array<std::uint32_t, kDigits> numbers{};
  // Unlike vectors and arrays, these do not check each access.
  std::uint32_t* starts = numbers.data();
  Keyed* sorted = to->data();
  for (const Keyed& one : from) ++starts[digit(one)];
  std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), 0u);
  for (const Keyed& one : from) sorted[starts[digit(one)]++] = one;
}

}  // namespace

void sort_by_key(std::vector<Keyed>* keyed) {
  if (keyed->size() < kFew) {
    std::stable_sort(keyed->begin(), keyed->end(),
                     [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
    return;
  }
  std::uint64_t varying = 0;
  for (const Keyed& one : *keyed) varying |= one.key ^ keyed->front().key;
  // Digits go from the last one to the first one; bits that all keys have in common are skipped.
  std::vector<Keyed> other(keyed->size());
  while (varying != 0) {
    const int first_bit = std::countr_zero(varying);
    sort_by_digit(*keyed, first_bit, &other);
    keyed->swap(other);
    varying &= ~((kDigits - 1) << first_bit);
  }
}

}  // namespace quadrille
