#pragma once

#include <algorithm>

#include "base/lanes.hpp"

namespace quadrille {

/// Points are processed in chunks of this many, which compilers vectorise and which fit the L1
/// cache.
inline constexpr int kChunk = 128;

/// Some values of each point of a chunk, a column for each value.
template <typename Scalar, int columns>
struct alignas(kLanes * sizeof(Scalar)) ChunkColumns {
  Scalar column[columns][kChunk];

  /// Clears the columns from the last point to the end of its vector.
  void clear_beyond(int size) {
    const int padded = (size + kLanes - 1) / kLanes * kLanes;
    for (auto& values : column) std::fill(values + size, values + padded, Scalar(0));
  }
};

/// Adds the products of column a with itself and the later ones to row a of N. Since `a` is known
/// at compile time, the sums stay in registers.
template <int a, typename Scalar, int columns>
QUADRILLE_INTO_CLONES void add_row(const ChunkColumns<Scalar, columns>& C, int size, double* N) {
  using Lanes = typename LanesOf<Scalar>::Type;
  Lanes sum[columns - a] = {};
  for (int k = 0; k < size; k += kLanes) {
    const Lanes left = reinterpret_cast<const Lanes&>(C.column[a][k]);
    for (int b = a; b < columns; ++b)
      sum[b - a] += left * reinterpret_cast<const Lanes&>(C.column[b][k]);
  }
  for (int b = a; b < columns; ++b) N[a * columns + b] += sum_of_lanes(sum[b - a]);
}

/// Adds the upper triangle of CᵀC from row a on.
/// @param C  cleared beyond the last point
/// @param N  rows of a square matrix
template <int a = 0, typename Scalar, int columns>
QUADRILLE_INTO_CLONES void add_rows(const ChunkColumns<Scalar, columns>& C, int size, double* N) {
  add_row<a>(C, size, N);
  if constexpr (a + 1 < columns) add_rows<a + 1>(C, size, N);
}

}  // namespace quadrille
