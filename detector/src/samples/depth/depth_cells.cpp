#include "samples/depth/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "base/vector_clones.hpp"
#include "samples/depth/cell_sums.hpp"

namespace quadrille {
namespace {

// Least distance between the mean depths of a cell's two sides, as a share of the distance between
// its extremes. It is nearly 1 for two layers, and a half for the two ends of a slope.
constexpr float kMinLayerGap = 0.75f;

CellGrid grid_of(const DepthCells& cells) {
  return {cells.image.corner.x(), cells.image.corner.y(), 1.0f / cells.tangent(), cells.width,
          cells.height};
}

QUADRILLE_VECTOR_CLONES
void look_up_cells(CellGrid grid, const SeenPoints& t, std::array<int, SeenPoints::kSize>* cells) {
  std::array<int, SeenPoints::kSize> found;
  for (int k = 0; k < SeenPoints::kSize; ++k) {
    const float x = (t.u[k] - grid.u0) * grid.per_unit, y = (t.v[k] - grid.v0) * grid.per_unit;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    // The casts round towards 0, so those of small negative numbers are inside; these are not.
    const int outside = static_cast<int>(x < 0.0f) | static_cast<int>(y < 0.0f) |
                        static_cast<int>(i >= grid.width) | static_cast<int>(j >= grid.height) |
                        static_cast<int>(!(t.w[k] > 0.0f));
    found[k] = (j * grid.width + i) | -outside;
  }
  *cells = found;
}

/// Nonzero for cells whose points do not continue each other.
using TornLanes = std::array<int, kLanes>;

/// Finds the torn ones among kLanes cells; returns nonzero if there are any.
QUADRILLE_VECTOR_CLONES
int find_torn(const float* n, const float* min_w, const float* max_w, float edge, TornLanes* torn) {
  int any = 0;
  for (int k = 0; k < kLanes; ++k) {
    const int far = !continuous(edge, min_w[k], max_w[k]), several = n[k] >= 2.0f;
    (*torn)[k] = far & several;
    any |= far & several;
  }
  return any;
}

/// Sums over the points on one side of a cell.
struct SideSums {
  float n = 0, u = 0, v = 0, w = 0;
};

/// A cell whose points do not continue each other, and the sums over those farther and nearer than
/// its middle depth.
struct SplitCell {
  int cell = 0;
  float middle = 0;
  SideSums far, near;

  bool is_layered(float min_w, float max_w) const {
    const float gap = near.w / near.n - far.w / far.n;
    return near.n > 1 && far.n > 1 && gap > kMinLayerGap * (max_w - min_w);
  }
};

std::vector<SplitCell> find_split(const DepthCells& cells, const CellSums& sums) {
  std::vector<SplitCell> split;
  for (int first = 0; first < cells.size(); first += kLanes) {
    TornLanes torn;
    const float *const min_w = sums.min_w.data() + first, *const max_w = sums.max_w.data() + first;
    if (!find_torn(sums.n.data() + first, min_w, max_w, cells.tangent(), &torn)) continue;
    for (int k = 0; k < kLanes; ++k) {
      if (torn[k]) split.push_back({first + k, 0.5f * (min_w[k] + max_w[k]), {}, {}});
    }
  }
  return split;
}

/// A cell across a depth edge keeps only the side, nearer or farther than its middle depth, with
/// more points.
/// @param of_point  the cell of each point looked at, −1 if unseen
/// @return the cells whose points lie in two clearly separate depths
std::vector<int> keep_larger_sides(const CloudView& cloud, const PinholeView& view,
                                   std::span<const int> of_point, const DepthCells& cells,
                                   CellSums* sums) {
  std::vector<SplitCell> split = find_split(cells, *sums);
  if (split.empty()) return {};
  // Entry c + 1 belongs to cell c, so that points without a cell have one too.
  std::vector<int> number_after(static_cast<std::size_t>(cells.size()) + 1, -1);
  int* const number = number_after.data() + 1;
  for (std::size_t s = 0; s < split.size(); ++s) number[split[s].cell] = static_cast<int>(s);
  const int *const begin = of_point.data(), *const end = begin + of_point.size();
  for (const int* cell = begin; cell != end; ++cell) {
    if (number[*cell] < 0) continue;
    SplitCell& s = split[number[*cell]];
    const Eigen::Vector3f t =
        view(cloud.points[static_cast<std::size_t>(cell - begin) * view.stride]);
    SideSums& side = t.z() > s.middle ? s.near : s.far;
    side.n += 1, side.u += t.x(), side.v += t.y(), side.w += t.z();
  }
  std::vector<int> layered;
  for (const SplitCell& s : split) {
    const int c = s.cell;
    if (s.is_layered(sums->min_w[c], sums->max_w[c])) layered.push_back(c);
    const SideSums& side = s.near.n >= s.far.n ? s.near : s.far;
    sums->n[c] = side.n, sums->u[c] = side.u, sums->v[c] = side.v, sums->w[c] = side.w;
  }
  return layered;
}

/// Share of the filled cells that lie within areas of layers: they or one of their neighbours at
/// most have none. In a single view cells have layers only across depth edges, which are lines and
/// not areas: along one, no more than six of nine have.
/// @param layered  the cells with layers
double layered_share(const DepthCells& cells, const std::vector<int>& layered) {
  if (layered.empty()) return 0.0;
  Mask has_layers(static_cast<std::size_t>(cells.size()), 0);
  for (const int c : layered) has_layers[c] = 1;
  int inside = 0;
  for (const int c : layered) {
    const int i = c % cells.width, j = c / cells.width;
    if (i == 0 || j == 0 || i + 1 == cells.width || j + 1 == cells.height) continue;
    int around = 0;
    for (const int row : {c - cells.width, c, c + cells.width}) {
      around += has_layers[row - 1] + has_layers[row] + has_layers[row + 1];
    }
    inside += around >= 8;
  }
  std::ptrdiff_t filled = 0;
  for (int j = 1; j + 1 < cells.height; ++j) {
    const int* const row = cells.count.data() + std::ptrdiff_t{j} * cells.width;
    filled += std::count_if(row + 1, row + cells.width - 1, [](int n) { return n > 0; });
  }
  return filled ? static_cast<double>(inside) / static_cast<double>(filled) : 0.0;
}

/// Divides sums over cells by their numbers of points; empty cells stay 0.
QUADRILLE_VECTOR_CLONES
void divide(const float* n, int size, float* sums) {
  for (int c = 0; c < size; ++c) {
    const int empty = static_cast<int>(n[c]) == 0;
    sums[c] /= n[c] + static_cast<float>(empty);
  }
}

QUADRILLE_VECTOR_CLONES
void round_down(const float* from, int size, int* to) {
  for (int c = 0; c < size; ++c) to[c] = static_cast<int>(from[c]);
}

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
[[gnu::always_inline]] inline void join_pairs(const DepthCells& fine, const FineRows& rows, int i,
                                              int n, JoinedLanes* joined) {
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

void DepthCells::look_up(const SeenPoints& points,
                         std::array<int, SeenPoints::kSize>* cells) const {
  look_up_cells(grid_of(*this), points, cells);
}

int DepthCells::cell_of(const Eigen::Vector3f& uvw) const {
  if (!(uvw.z() > 0.0f)) return -1;
  const CellGrid grid = grid_of(*this);
  const float x = (uvw.x() - grid.u0) * grid.per_unit, y = (uvw.y() - grid.v0) * grid.per_unit;
  if (!(x >= 0.0f && y >= 0.0f)) return -1;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  if (i >= width || j >= height) return -1;
  const int c = j * width + i;
  return holds(c, uvw.z()) ? c : -1;
}

bool DepthCells::holds(int c, float w_point) const {
  return count[c] > 0 && continuous(*this, w_point, w[c]);
}

DepthCells make_depth_cells(const CloudView& cloud, const PinholeView& view,
                            const PinholeImage& image, int pixels) {
  DepthCells cells;
  cells.image = image;
  cells.pixels = pixels;
  cells.width = (image.width + pixels - 1) / pixels;
  cells.height = (image.height + pixels - 1) / pixels;
  const int size = cells.size();
  CellSums sums(static_cast<std::size_t>(size));
  const std::size_t looked = view.looked_at(cloud.points.size());
  // Filled by add_points(), so it is not set to 0 first.
  const auto of_point = std::make_unique_for_overwrite<int[]>(looked + SeenPoints::kSize);
  add_points(cloud, view, grid_of(cells), of_point.get(), &sums);
  const std::vector<int> layered =
      keep_larger_sides(cloud, view, {of_point.get(), looked}, cells, &sums);

  cells.count.resize(static_cast<std::size_t>(size));
  round_down(sums.n.data(), size, cells.count.data());
  for (auto [sum, mean] :
       {std::pair(&sums.u, &cells.u), std::pair(&sums.v, &cells.v), std::pair(&sums.w, &cells.w)}) {
    divide(sums.n.data(), size, sum->data());
    sum->resize(static_cast<std::size_t>(size));
    *mean = std::move(*sum);
  }
  cells.layered = layered_share(cells, layered);
  return cells;
}

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
