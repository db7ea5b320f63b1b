#include "samples/depth/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/mask.hpp"
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
    for (int i = 1; i + 1 < cells.width; ++i) filled += row[i] > 0;
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

}  // namespace quadrille
