#include "samples/depth/coarser_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

/// A row of finer cells with the number of points in each; cells that are not kept count as empty.
struct FineRow {
  std::vector<float> n;
  /// The inverse depth of filled cells; for empty ones, what changes no minimum and no maximum.
  std::vector<float> low, high;
  /// The first cell of the row.
  int first = 0;

  explicit FineRow(int width) : n(static_cast<std::size_t>(width)), low(n.size()), high(n.size()) {}

  /// @param row  one below the image is empty
  void read(const DepthCells& cells, const Mask& keep, int row);
};

// Comparisons of floating-point numbers would keep the compiler from vectorising this.
QUADRILLE_VECTOR_CLONES
void read_cells(const int* __restrict count, const char* __restrict keep, const float* __restrict w,
                int width, FineRow* row) {
  float* __restrict const n = row->n.data();
  float *const low = row->low.data(), *const high = row->high.data();
  if (keep) {
    for (int i = 0; i < width; ++i) {
      n[i] = static_cast<float>(count[i] * static_cast<int>(keep[i] != 0));
    }
  } else {
    for (int i = 0; i < width; ++i) n[i] = static_cast<float>(count[i]);
  }
  for (int i = 0; i < width; ++i) {
    const auto filled = static_cast<float>(std::min(static_cast<int>(n[i]), 1));
    high[i] = filled * w[i];
    low[i] = high[i] + (1.0f - filled) * PinholeView::kMaxInverseDepth;
  }
}

void FineRow::read(const DepthCells& cells, const Mask& keep, int row) {
  first = std::min(row, cells.height - 1) * cells.width;
  if (row < cells.height) {
    read_cells(cells.count.data() + first, keep.empty() ? nullptr : keep.data() + first,
               cells.w.data() + first, cells.width, this);
  } else {
    std::fill(n.begin(), n.end(), 0.0f), high = n;
    std::fill(low.begin(), low.end(), PinholeView::kMaxInverseDepth);
  }
}

/// Two adjacent rows of finer cells.
using FineRows = std::array<FineRow, 2>;

/// Means over some joined cells with the extremes of the inverse depth, and whether they span a
/// depth edge.
struct JoinedLanes {
  std::array<int, kLanes> count, torn;
  std::array<float, kLanes> u, v, w, min_w, max_w;
};

/// Joins the cells of two rows two by two.
/// @param i  the first of them
/// @param n  number of joined cells
QUADRILLE_INTO_CLONES void join_pairs(const DepthCells& fine, const FineRows& rows, int i, int n,
                                      JoinedLanes* joined) {
  const float *const n0 = rows[0].n.data() + i, *const n1 = rows[1].n.data() + i;
  const float *const low0 = rows[0].low.data() + i, *const low1 = rows[1].low.data() + i;
  const float *const high0 = rows[0].high.data() + i, *const high1 = rows[1].high.data() + i;
  const int c0 = rows[0].first + i, c1 = rows[1].first + i;
  const float *const u0 = fine.u.data() + c0, *const u1 = fine.u.data() + c1;
  const float *const v0 = fine.v.data() + c0, *const v1 = fine.v.data() + c1;
  const float *const w0 = fine.w.data() + c0, *const w1 = fine.w.data() + c1;
  const auto sum = [&](const float* a, const float* b, int k) {
    return n0[k] * a[k] + n0[k + 1] * a[k + 1] + n1[k] * b[k] + n1[k + 1] * b[k + 1];
  };
  for (int j = 0; j < n; ++j) {
    const int k = 2 * j;
    const float total = n0[k] + n0[k + 1] + n1[k] + n1[k + 1];
    const int count = static_cast<int>(total);
    const float over = 1.0f / (total + static_cast<float>(static_cast<int>(count == 0)));
    joined->count.data()[j] = count;
    joined->u.data()[j] = sum(u0, u1, k) * over;
    joined->v.data()[j] = sum(v0, v1, k) * over;
    joined->w.data()[j] = sum(w0, w1, k) * over;
    joined->min_w.data()[j] =
        std::min(std::min(low0[k], low0[k + 1]), std::min(low1[k], low1[k + 1]));
    joined->max_w.data()[j] =
        std::max(std::max(high0[k], high0[k + 1]), std::max(high1[k], high1[k + 1]));
  }
}

/// Joins up to kLanes pairs of cells of two rows; returns nonzero if a joined cell is torn.
QUADRILLE_VECTOR_CLONES
int join(const DepthCells& fine, const FineRows& rows, int i, int n, float edge,
         JoinedLanes* joined) {
  JoinedLanes lanes{};
  if (n == kLanes) {
    join_pairs(fine, rows, i, kLanes, &lanes);
  } else {
    join_pairs(fine, rows, i, n, &lanes);
  }
  int any = 0;
  for (int k = 0; k < kLanes; ++k) {
    const int far = !continuous(edge, lanes.min_w[k], lanes.max_w[k]);
    const int filled = lanes.count[k] > 0;
    lanes.torn[k] = far & filled;
    any |= far & filled;
  }
  *joined = lanes;
  return any;
}

/// Joins only those cells under coarse cell (i, j) whose depth continues that of the middle one, in
/// the order of inverse depth.
void join_side_of_middle(const DepthCells& fine, const FineRows& rows, int i, int first,
                         DepthCells* cells) {
  // Number of points and cell, sorted by inverse depth.
  std::array<std::pair<float, int>, 4> child{};
  int n = 0;
  for (int r = 0; r < 2; ++r) {
    for (int k = 2 * i; k < std::min(2 * i + 2, fine.width); ++k) {
      const int c = rows[r].first + k;
      if (rows[r].n[k] == 0) continue;
      int at = n++;
      for (; at > 0 && fine.w[child[at - 1].second] > fine.w[c]; --at) child[at] = child[at - 1];
      child[at] = {rows[r].n[k], c};
    }
  }
  if (n == 0) return;
  const float middle = fine.w[child[n / 2].second];
  float total = 0, u = 0, v = 0, w = 0;
  for (int k = 0; k < n; ++k) {
    const auto [m, c] = child[k];
    if (!continuous(*cells, fine.w[c], middle)) continue;
    total += m, u += m * fine.u[c], v += m * fine.v[c], w += m * fine.w[c];
  }
  const int c = first + i;
  cells->count[c] = static_cast<int>(total);
  cells->u[c] = u / total, cells->v[c] = v / total, cells->w[c] = w / total;
}

}  // namespace

DepthCells coarser(const DepthCells& fine, const Mask& keep) {
  DepthCells cells;
  cells.image = fine.image;
  cells.pixels = 2 * fine.pixels;
  cells.width = (fine.width + 1) / 2;
  cells.height = (fine.height + 1) / 2;
  const std::size_t size = static_cast<std::size_t>(cells.size());
  cells.count.resize(size);
  cells.u.resize(size), cells.v.resize(size), cells.w.resize(size);
  FineRows rows = {FineRow(fine.width), FineRow(fine.width)};
  for (int j = 0; j < cells.height; ++j) {
    for (int r = 0; r < 2; ++r) rows[r].read(fine, keep, 2 * j + r);
    const int first = j * cells.width, pairs = fine.width / 2;
    for (int from = 0; from < pairs; from += kLanes) {
      // The last lanes repeat some before if they would be fewer.
      const int i = std::min(from, std::max(0, pairs - kLanes)), n = std::min(kLanes, pairs);
      JoinedLanes joined;
      const int any = join(fine, rows, 2 * i, n, cells.tangent(), &joined);
      std::copy_n(joined.count.data(), n, cells.count.data() + first + i);
      std::copy_n(joined.u.data(), n, cells.u.data() + first + i);
      std::copy_n(joined.v.data(), n, cells.v.data() + first + i);
      std::copy_n(joined.w.data(), n, cells.w.data() + first + i);
      for (int k = 0; any && k < n; ++k) {
        if (joined.torn[k]) join_side_of_middle(fine, rows, i + k, first, &cells);
      }
    }
    // A last cell under which there is only one column.
    if (pairs < cells.width) join_side_of_middle(fine, rows, pairs, first, &cells);
  }
  return cells;
}

}  // namespace quadrille
