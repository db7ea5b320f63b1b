#include "base/zeroed_vector.hpp"

#include <algorithm>
#include <cstddef>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("a vector made with its size holds zeros, also in memory that was used before",
          "[zeroed_vector]") {
  for (int round = 0; round < 20; ++round) {
    ZeroedVector<int> zeros(1000 + 100 * static_cast<std::size_t>(round));
    CHECK(std::count(zeros.begin(), zeros.end(), 0) == static_cast<std::ptrdiff_t>(zeros.size()));
    // The next vector may get this memory.
    std::fill(zeros.begin(), zeros.end(), -1);
  }
}

TEST_CASE("a copy of a vector has its values", "[zeroed_vector]") {
  ZeroedVector<char> some(100);
  some[7] = 3;
  const ZeroedVector<char> copy = some;
  some[7] = 4;
  CHECK(copy[7] == 3);
  CHECK(std::count(copy.begin(), copy.end(), 0) == 99);
  CHECK(ZeroedVector<int>(3, 5) == ZeroedVector<int>{5, 5, 5});
}
