#include "samples/depth/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

// Least distance between the mean depths of a cell's two sides, as a share of the distance between
// its extremes. It is nearly 1 for two layers, and a half for the two ends of a slope.
constexpr float kMinLayerGap = 0.75f;

/// Sums of tangents and inverse depth over points, and the extremes of the inverse depth.
struct Sums {
  float n = 0, u = 0, v = 0, w = 0;
  float min_w = PinholeView::kMaxInverseDepth, max_w = 0;

  void add(float u_k, float v_k, float w_k) {
    n += 1, u += u_k, v += v_k, w += w_k;
    min_w = std::min(min_w, w_k);
    max_w = std::max(max_w, w_k);
  }
  void add(const Sums& other) {
    n += other.n, u += other.u, v += other.v, w += other.w;
    min_w = std::min(min_w, other.min_w);
    max_w = std::max(max_w, other.max_w);
  }
};

/// Finds the cells of points, −1 for unseen points. No point lies left of or above the image's
/// corner.
struct CellIndex {
  float u0, v0, step;
  int width, last_i, last_j;

  explicit CellIndex(const DepthCells& cells)
      : u0(cells.image.corner.x()),
        v0(cells.image.corner.y()),
        step(1.0f / (cells.pitch() * static_cast<float>(cells.pixels))),
        width(cells.width),
        last_i(cells.width - 1),
        last_j(cells.height - 1) {}
};

// The compiler makes vectors of this only if the index comes by value and nothing branches.
QUADRILLE_VECTOR_CLONES
void find_cells(CellIndex index, const SeenPoints& t, int* cell) {
  for (int k = 0; k < SeenPoints::kSize; ++k) {
    const int i = std::min(static_cast<int>((t.u[k] - index.u0) * index.step), index.last_i);
    const int j = std::min(static_cast<int>((t.v[k] - index.v0) * index.step), index.last_j);
    const int unseen = -static_cast<int>(!(t.w[k] > 0.0f));
    cell[k] = (j * index.width + i) | unseen;
  }
}

/// Adds points to the sums of their cells. Consecutive points mostly share a cell, so their sums
/// stay in registers.
void add_runs(const SeenPoints& t, const int* cell, std::vector<Sums>* sums) {
  for (int k = 0; k < SeenPoints::kSize;) {
    const int c = cell[k];
    Sums run;
    do {
      run.add(t.u[k], t.v[k], t.w[k]);
    } while (++k < SeenPoints::kSize && cell[k] == c);
    if (c >= 0) (*sums)[c].add(run);
  }
}

/// Sums up the points of each cell; of_point receives the cell of each point looked at, −1 if
/// unseen.
std::vector<Sums> sum_up(const CloudView& cloud, const PinholeView& view, const DepthCells& cells,
                         std::vector<int>* of_point) {
  constexpr std::size_t kSize = SeenPoints::kSize;
  const CellIndex index(cells);
  std::vector<Sums> sums(static_cast<std::size_t>(cells.size()));
  const std::size_t looked = view.looked_at(cloud.points.size());
  of_point->resize((looked + kSize - 1) / kSize * kSize);
  for (std::size_t first = 0; first < looked; first += kSize) {
    const SeenPoints t = view.look(cloud.points, first);
    int* const cell = of_point->data() + first;
    find_cells(index, t, cell);
    add_runs(t, cell, &sums);
  }
  return sums;
}

/// A cell across a depth edge keeps only the side, nearer or farther than its middle depth, with
/// more points.
/// @return per cell, whether its points lie in two clearly separate depths; empty if no cell's do
std::vector<char> keep_larger_sides(const CloudView& cloud, const PinholeView& view,
                                    const std::vector<int>& of_point, const DepthCells& cells,
                                    std::vector<Sums>* sums) {
  std::vector<int> split(sums->size(), -1);
  std::vector<std::array<Sums, 2>> sides;
  std::vector<float> middle;
  for (std::size_t c = 0; c < split.size(); ++c) {
    const Sums& sum = (*sums)[c];
    if (sum.n < 2 || continuous(cells, sum.min_w, sum.max_w)) continue;
    split[c] = static_cast<int>(sides.size());
    sides.emplace_back();
    middle.push_back(0.5f * (sum.min_w + sum.max_w));
  }
  if (sides.empty()) return {};
  for (std::size_t k = 0; k < view.looked_at(cloud.points.size()); ++k) {
    const int s = of_point[k] < 0 ? -1 : split[of_point[k]];
    if (s < 0) continue;
    const Eigen::Vector3f t = view(cloud.points[k * static_cast<std::size_t>(view.stride)]);
    sides[s][t.z() > middle[s]].add(t.x(), t.y(), t.z());
  }
  std::vector<char> layered(split.size(), 0);
  for (std::size_t c = 0; c < split.size(); ++c) {
    if (split[c] < 0) continue;
    const auto& [far, near] = sides[split[c]];
    const Sums& sum = (*sums)[c];
    const float gap = near.w / near.n - far.w / far.n;
    layered[c] = near.n > 1 && far.n > 1 && gap > kMinLayerGap * (sum.max_w - sum.min_w);
    (*sums)[c] = near.n >= far.n ? near : far;
  }
  return layered;
}

/// Share of the filled cells that lie within areas of layers: they or one of their neighbours at
/// most have none. In a single view cells have layers only across depth edges, which are lines and
/// not areas: along one, no more than six of nine have.
double layered_share(const DepthCells& cells, const std::vector<char>& layered) {
  if (layered.empty()) return 0.0;
  int inside = 0, filled = 0;
  for (int j = 1; j + 1 < cells.height; ++j) {
    for (int i = 1; i + 1 < cells.width; ++i) {
      const int c = j * cells.width + i;
      filled += cells.count[c] > 0;
      if (!layered[c]) continue;
      int around = 0;
      for (const int row : {c - cells.width, c, c + cells.width}) {
        around += layered[row - 1] + layered[row] + layered[row + 1];
      }
      inside += around >= 8;
    }
  }
  return filled ? static_cast<double>(inside) / filled : 0.0;
}

/// Two adjacent rows of finer cells, with the number of points in each cell; cells that are not
/// kept count as empty.
struct FineRows {
  std::array<std::vector<float>, 2> n;
  std::array<int, 2> first{};

  FineRows(const DepthCells& cells, const Mask& keep, int j) {
    for (int r = 0; r < 2; ++r) {
      n[r].assign(static_cast<std::size_t>(cells.width), 0.0f);
      // Rows below the image are empty.
      first[r] = std::min(2 * j + r, cells.height - 1) * cells.width;
      if (2 * j + r >= cells.height) continue;
      for (int i = 0; i < cells.width; ++i) {
        const int c = first[r] + i;
        n[r][i] = keep.empty() || keep[c] ? static_cast<float>(cells.count[c]) : 0.0f;
      }
    }
  }
};

/// Joins cells two by two, and reports which joined cells span a depth edge.
QUADRILLE_VECTOR_CLONES
void join(const DepthCells& fine, const FineRows& rows, int n, int first, DepthCells* cells,
          char* torn) {
  for (int i = 0; i < n; ++i) {
    float total = 0, u = 0, v = 0, w = 0, min_w = PinholeView::kMaxInverseDepth, max_w = 0;
    for (int r = 0; r < 2; ++r) {
      for (int k = 2 * i; k < 2 * i + 2; ++k) {
        const int c = rows.first[r] + k;
        const float m = rows.n[r][k], w_c = fine.w[c];
        total += m, u += m * fine.u[c], v += m * fine.v[c], w += m * w_c;
        min_w = std::min(min_w, m > 0 ? w_c : min_w);
        max_w = std::max(max_w, m > 0 ? w_c : max_w);
      }
    }
    const float over = 1.0f / std::max(total, 1.0f);
    const int c = first + i;
    cells->count[c] = static_cast<int>(total);
    cells->u[c] = u * over, cells->v[c] = v * over, cells->w[c] = w * over;
    torn[i] = (total > 0) & !continuous(*cells, min_w, max_w);
  }
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
      const int c = rows.first[r] + k;
      if (rows.n[r][k] == 0) continue;
      int at = n++;
      for (; at > 0 && fine.w[child[at - 1].second] > fine.w[c]; --at) child[at] = child[at - 1];
      child[at] = {rows.n[r][k], c};
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

int DepthCells::cell_of(const Eigen::Vector3f& uvw) const {
  if (!(uvw.z() > 0.0f)) return -1;
  const CellIndex index(*this);
  const int i = static_cast<int>(std::floor((uvw.x() - index.u0) * index.step));
  const int j = static_cast<int>(std::floor((uvw.y() - index.v0) * index.step));
  if (i < 0 || j < 0 || i > index.last_i || j > index.last_j) return -1;
  const int c = j * width + i;
  return count[c] > 0 && continuous(*this, uvw.z(), w[c]) ? c : -1;
}

DepthCells make_depth_cells(const CloudView& cloud, const PinholeView& view,
                            const PinholeImage& image, int pixels) {
  DepthCells cells;
  cells.image = image;
  cells.pixels = pixels;
  cells.width = (image.width + pixels - 1) / pixels;
  cells.height = (image.height + pixels - 1) / pixels;
  std::vector<int> of_point;
  std::vector<Sums> sums = sum_up(cloud, view, cells, &of_point);
  const std::vector<char> layered = keep_larger_sides(cloud, view, of_point, cells, &sums);

  cells.count.resize(sums.size());
  cells.u.resize(sums.size()), cells.v.resize(sums.size()), cells.w.resize(sums.size());
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const Sums& s = sums[c];
    cells.count[c] = static_cast<int>(s.n);
    if (s.n == 0) continue;
    cells.u[c] = s.u / s.n, cells.v[c] = s.v / s.n, cells.w[c] = s.w / s.n;
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
  std::vector<char> torn(static_cast<std::size_t>(cells.width), 1);
  for (int j = 0; j < cells.height; ++j) {
    const FineRows rows(fine, keep, j);
    const int first = j * cells.width;
    join(fine, rows, fine.width / 2, first, &cells, torn.data());
    for (int i = 0; i < cells.width; ++i) {
      if (torn[i]) join_side_of_middle(fine, rows, i, first, &cells);
    }
  }
  return cells;
}

}  // namespace quadrille
