#include "base/buckets.hpp"

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("numbers are sorted into their buckets in order, and some into none", "[buckets]") {
  const Buckets buckets = sort_into_buckets(std::vector<int>{2, 0, -1, 2, 0, 2}, 4);
  CHECK(buckets.size() == 4);
  const std::vector<std::vector<int>> expected = {{1, 4}, {}, {0, 3, 5}, {}};
  for (int b = 0; b < 4; ++b) {
    CHECK(std::vector<int>(buckets[b].begin(), buckets[b].end()) == expected[b]);
  }
  CHECK(sort_into_buckets({}, 0).size() == 0);
}
