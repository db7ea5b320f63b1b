#include "samples/depth/cell_sums.hpp"

#include <algorithm>
#include <array>

#include "base/vector_clones.hpp"
#include "cloud/look_at.hpp"

namespace quadrille {
namespace {

constexpr int kChunk = SeenPoints::kSize;
static_assert(kChunk == 2 * kLanes);

/// Places of the sums in memory.
struct SumPointers {
  float *n, *u, *v, *w, *min_w, *max_w;
};

/// Cells of some points, −1 for unseen points.
using PointCells = std::array<int, kChunk>;

// The compiler makes vectors of this only if the grid comes by value and nothing branches.
QUADRILLE_INTO_CLONES PointCells cells_of(CellGrid grid, const SeenPoints& t) {
  PointCells cells;
  const int last_i = grid.width - 1, last_j = grid.height - 1;
  for (int k = 0; k < kChunk; ++k) {
    const int i = std::min(static_cast<int>((t.u[k] - grid.u0) * grid.per_unit), last_i);
    const int j = std::min(static_cast<int>((t.v[k] - grid.v0) * grid.per_unit), last_j);
    const int unseen = -static_cast<int>(!(t.w[k] > 0.0f));
    cells[k] = (j * grid.width + i) | unseen;
  }
  return cells;
}

/// Adds points to the sums of their cells, run by run of points that share a cell.
QUADRILLE_INTO_CLONES void add_runs(const SeenPoints& t, const PointCells& cells,
                                    const SumPointers& sums) {
  const float *const u_k = t.u.data(), *const v_k = t.v.data(), *const w_k = t.w.data();
  for (int k = 0; k < kChunk;) {
    const int c = cells.data()[k];
    float n = 0, u = 0, v = 0, w = 0, min_w = PinholeView::kMaxInverseDepth, max_w = 0;
    do {
      n += 1, u += u_k[k], v += v_k[k], w += w_k[k];
      min_w = std::min(min_w, w_k[k]);
      max_w = std::max(max_w, w_k[k]);
    } while (++k < kChunk && cells.data()[k] == c);
    if (c < 0) continue;
    sums.n[c] += n, sums.u[c] += u, sums.v[c] += v, sums.w[c] += w;
    sums.min_w[c] = std::min(sums.min_w[c], min_w);
    sums.max_w[c] = std::max(sums.max_w[c], max_w);
  }
}

/// True if the points are pairs in consecutive cells: two in each from the first cell on.
/// @param alone  1 if the first point is alone in its cell, and so the last; otherwise 0
QUADRILLE_INTO_CLONES bool are_pairs(const PointCells& cells, int alone) {
  int other = 0;
  QUADRILLE_KEEP_LOOP
  for (int k = 0; k < kChunk; ++k) other |= cells[k] ^ (cells[0] + ((k + alone) >> 1));
  return other == 0 && cells[0] >= 0;
}

// Number of values in a pair.
constexpr std::ptrdiff_t kPair = 2;

/// Adds pairs of values to consecutive sums.
QUADRILLE_INTO_CLONES void sum_pairs(const float* __restrict pairs, float* __restrict sums) {
  QUADRILLE_KEEP_LOOP
  for (int k = 0; k < kLanes; ++k) sums[k] += pairs[kPair * k] + pairs[kPair * k + 1];
}

QUADRILLE_INTO_CLONES void lower_to(const float* __restrict pairs, float* __restrict least) {
  QUADRILLE_KEEP_LOOP
  for (int k = 0; k < kLanes; ++k) {
    const float a = pairs[kPair * k], b = pairs[kPair * k + 1], low = b < a ? b : a,
                before = least[k];
    least[k] = low < before ? low : before;
  }
}

QUADRILLE_INTO_CLONES void raise_to(const float* __restrict pairs, float* __restrict most) {
  QUADRILLE_KEEP_LOOP
  for (int k = 0; k < kLanes; ++k) {
    const float a = pairs[kPair * k], b = pairs[kPair * k + 1], high = b > a ? b : a,
                before = most[k];
    most[k] = high > before ? high : before;
  }
}

/// Adds pairs of points to consecutive sums.
/// @param low  inverse depths of which the least count
QUADRILLE_INTO_CLONES void add_pairs(const float* n, const float* u, const float* v, const float* w,
                                     const float* low, const SumPointers& sums, int c) {
  sum_pairs(n, sums.n + c);
  sum_pairs(u, sums.u + c);
  sum_pairs(v, sums.v + c);
  sum_pairs(w, sums.w + c);
  lower_to(low, sums.min_w + c);
  raise_to(w, sums.max_w + c);
}

/// Values of points with a place before and one behind them that add nothing.
struct Padded {
  std::array<float, kChunk + 2> values;

  QUADRILLE_INTO_CLONES Padded(const std::array<float, kChunk>& of_points, float nothing) {
    values.front() = values.back() = nothing;
    std::copy_n(of_points.data(), kChunk, values.data() + 1);
  }
};

/// Adds points for which are_pairs(cells, 1) holds.
QUADRILLE_INTO_CLONES void add_late_pairs(const SeenPoints& t, const SumPointers& sums, int c) {
  std::array<float, kChunk> ones;
  ones.fill(1.0f);
  const Padded n(ones, 0.0f), u(t.u, 0.0f), v(t.v, 0.0f), w(t.w, 0.0f);
  const Padded low(t.w, PinholeView::kMaxInverseDepth);
  add_pairs(n.values.data(), u.values.data(), v.values.data(), w.values.data(), low.values.data(),
            sums, c);
  const int last = c + kLanes;
  constexpr int kLast = kChunk - 1;
  sums.n[last] += 1.0f, sums.u[last] += t.u[kLast], sums.v[last] += t.v[kLast];
  sums.w[last] += t.w[kLast];
  sums.min_w[last] = std::min(sums.min_w[last], t.w[kLast]);
  sums.max_w[last] = std::max(sums.max_w[last], t.w[kLast]);
}

QUADRILLE_VECTOR_CLONES
void add_all(const CloudView& cloud, const PinholeView& view, CellGrid grid, int* of_point,
             SumPointers sums) {
  std::array<float, kChunk> ones;
  ones.fill(1.0f);
  const std::size_t looked = view.looked_at(cloud.points.size());
  for (std::size_t first = 0; first < looked; first += kChunk) {
    const SeenPoints t = look_at(view, cloud.points, first);
    const PointCells cells = cells_of(grid, t);
    std::copy_n(cells.data(), kChunk, of_point + first);
    // Points of an image come row by row, so if a cell is two pixels wide, most come in pairs,
    // which vectors add eight at once. The sums are the same as those of runs.
    if (are_pairs(cells, 0)) {
      add_pairs(ones.data(), t.u.data(), t.v.data(), t.w.data(), t.w.data(), sums, cells[0]);
    } else if (are_pairs(cells, 1)) {
      add_late_pairs(t, sums, cells[0]);
    } else {
      add_runs(t, cells, sums);
    }
  }
}

}  // namespace

CellSums::CellSums(std::size_t cells)
    : n(cells + kLanes, 0.0f),
      u(n),
      v(n),
      w(n),
      min_w(n.size(), PinholeView::kMaxInverseDepth),
      max_w(n) {}

void add_points(const CloudView& cloud, const PinholeView& view, const CellGrid& grid,
                int* of_point, CellSums* sums) {
  add_all(cloud, view, grid, of_point,
          {sums->n.data(), sums->u.data(), sums->v.data(), sums->w.data(), sums->min_w.data(),
           sums->max_w.data()});
}

}  // namespace quadrille
