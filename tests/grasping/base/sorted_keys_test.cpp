#include "base/sorted_keys.hpp"

#include <algorithm>
#include <random>

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("keys are sorted, and equal ones stay in their order", "[sorted_keys]") {
  std::mt19937_64 random(11);
  for (const std::size_t count : {0, 1, 2, 199, 200, 5000}) {
    // Few bits vary, many do, or all.
    for (const std::uint64_t bits : {0x0ull, 0x7ull, 0x7ff0000000003ffull, ~0ull}) {
      std::vector<Keyed> keyed;
      for (std::size_t n = 0; n < count; ++n) {
        const std::uint64_t common = 0x123456789abcdefull & ~bits;
        keyed.push_back({common | (random() & bits), static_cast<int>(n)});
      }
      std::vector<Keyed> expected = keyed;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
      sort_by_key(&keyed);
      REQUIRE(keyed.size() == expected.size());
      CHECK(std::equal(
          keyed.begin(), keyed.end(), expected.begin(),
          [](const Keyed& a, const Keyed& b) { return a.key == b.key && a.index == b.index; }));
    }
  }
}

}  // namespace quadrille
