#include "fit/column_products.hpp"

#include <array>
#include <cstdint>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr int kProductColumns = 5;

/// Adds the products of `size` rows of small whole numbers, of which sums are exact in either
/// precision, and compares them with plain loops.
template <typename Scalar>
void check_products(int size) {
  RandomStream random(5, static_cast<std::uint64_t>(size));
  ChunkColumns<Scalar, kProductColumns> C;
  for (auto& column : C.column) {
    // Fill all rows, so that the test fails if rows beyond `size` count.
    for (Scalar& value : column) value = static_cast<Scalar>(random.below(2001) - 1000);
  }
  C.clear_beyond(size);
  std::array<double, kProductColumns * kProductColumns> N;
  N.fill(7.0);
  add_rows(C, size, N.data());
  for (int a = 0; a < kProductColumns; ++a) {
    for (int b = 0; b < kProductColumns; ++b) {
      double expected = 7.0;
      for (int k = 0; k < size && b >= a; ++k) {
        expected += static_cast<double>(C.column[a][k]) * static_cast<double>(C.column[b][k]);
      }
      INFO("size " << size << ", row " << a << ", column " << b);
      CHECK(N[static_cast<std::size_t>(a * kProductColumns + b)] == expected);
    }
  }
}

}  // namespace

TEST_CASE("products of columns are added to the upper triangle, whatever lies beyond the points",
          "[fit][products]") {
  // None, and below, at and above whole vectors.
  for (const int size : {0, 1, 7, 8, 9, 64, kChunk - 1, kChunk}) {
    // The sum of nine of these products stays below 2²⁴, up to which floats are exact.
    if (size <= 9) check_products<float>(size);
    check_products<double>(size);
  }
}

TEST_CASE("the sum of lanes is that of all values", "[fit][products]") {
  const LanesOf<float>::Type floats = {1, 2, 4, 8, 16, 32, 64, 128};
  CHECK(sum_of_lanes(floats) == 255.0);
  const LanesOf<double>::Type doubles = {1, -2, 4, -8, 16, -32, 64, -128};
  CHECK(sum_of_lanes(doubles) == -85.0);
}
