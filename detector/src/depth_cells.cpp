#include "quadrille/detector/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {
namespace {

// Depths that differ by this factor are layers, not the two ends of a slope.
constexpr float kLayer = 1.05f;

/// Sums of (u, v, w, 1) and the extremes of w.
struct Sums {
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  float least = 1e30f, most = 0;

  float n() const { return sum[3]; }
  float w() const { return sum[2] / sum[3]; }
  void add(const Eigen::Vector4f& t) {
    sum += t;
    least = std::min(least, t.z());
    most = std::max(most, t.z());
  }
  void add(const Sums& other) {
    sum += other.sum;
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
};

/// The cell that a projected point falls into; none lies before the image's corner.
struct CellIndex {
  float u0, v0, step;
  int width, last_i, last_j;

  explicit CellIndex(const DepthCells& cells)
      : u0(cells.image.u0),
        v0(cells.image.v0),
        step(1.0f / (cells.image.pitch * static_cast<float>(cells.pixels))),
        width(cells.width),
        last_i(cells.width - 1),
        last_j(cells.height - 1) {}
  int operator()(const Eigen::Vector4f& t) const {
    const int i = std::min(static_cast<int>((t.x() - u0) * step), last_i);
    const int j = std::min(static_cast<int>((t.y() - v0) * step), last_j);
    return j * width + i;
  }
};

/// Sums of the points of each cell; of_point gets the cell of each point.
std::vector<Sums> sum_up(const std::vector<Eigen::Vector4f>& uvw, const CellIndex& cell_of,
                         int size, std::vector<int>* of_point) {
  std::vector<Sums> sums(static_cast<std::size_t>(size));
  of_point->resize(uvw.size());
  // Consecutive points mostly share a cell: their sums stay in registers.
  Sums run;
  int cell = cell_of(uvw.front());
  for (std::size_t k = 0; k < uvw.size(); ++k) {
    const int c = cell_of(uvw[k]);
    (*of_point)[k] = c;
    if (c != cell) {
      sums[cell].add(run);
      run = {};
      cell = c;
    }
    run.add(uvw[k]);
  }
  sums[cell].add(run);
  return sums;
}

/// Of cells across a depth edge, keeps the side, near or far of the middle, that has more points.
/// @return the share of the filled cells that have layers
double keep_larger_sides(const std::vector<Eigen::Vector4f>& uvw, const std::vector<int>& of_point,
                         const DepthCells& cells, std::vector<Sums>* sums) {
  std::vector<int> split(sums->size(), -1);
  std::vector<std::array<Sums, 2>> sides;
  std::vector<float> middle;
  int filled = 0;
  for (std::size_t c = 0; c < split.size(); ++c) {
    const Sums& sum = (*sums)[c];
    filled += sum.n() > 1;
    if (sum.n() < 2 || continuous(cells, sum.least, sum.most)) continue;
    split[c] = static_cast<int>(sides.size());
    sides.emplace_back();
    middle.push_back(0.5f * (sum.least + sum.most));
  }
  if (sides.empty()) return 0.0;
  for (std::size_t k = 0; k < uvw.size(); ++k) {
    const int s = split[of_point[k]];
    if (s >= 0) sides[s][uvw[k].z() > middle[s]].add(uvw[k]);
  }
  int layered = 0;
  for (std::size_t c = 0; c < split.size(); ++c) {
    if (split[c] < 0) continue;
    const auto& [far, near] = sides[split[c]];
    layered += near.n() > 1 && far.n() > 1 && near.w() > kLayer * far.w();
    (*sums)[c] = near.n() >= far.n() ? near : far;
  }
  return filled ? static_cast<double>(layered) / filled : 0.0;
}

}  // namespace

DepthCells make_depth_cells(const Projection& projection, const PinholeImage& image, int pixels) {
  DepthCells cells;
  cells.image = image;
  cells.pixels = pixels;
  cells.width = (image.width + pixels - 1) / pixels;
  cells.height = (image.height + pixels - 1) / pixels;
  std::vector<int> of_point;
  std::vector<Sums> sums = sum_up(projection.uvw, CellIndex(cells), cells.size(), &of_point);
  cells.layered = keep_larger_sides(projection.uvw, of_point, cells, &sums);

  cells.count.resize(sums.size());
  cells.u.resize(sums.size()), cells.v.resize(sums.size()), cells.w.resize(sums.size());
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const Eigen::Vector4f& sum = sums[c].sum;
    cells.count[c] = static_cast<int>(sum[3]);
    if (sum[3] == 0) continue;
    cells.u[c] = sum[0] / sum[3];
    cells.v[c] = sum[1] / sum[3];
    cells.w[c] = sum[2] / sum[3];
  }
  return cells;
}

DepthCells coarser(const DepthCells& fine, const std::vector<char>& keep) {
  DepthCells cells;
  cells.image = fine.image;
  cells.pixels = 2 * fine.pixels;
  cells.width = (fine.width + 1) / 2;
  cells.height = (fine.height + 1) / 2;
  const std::size_t size = static_cast<std::size_t>(cells.size());
  cells.count.assign(size, 0);
  cells.u.assign(size, 0), cells.v.assign(size, 0), cells.w.assign(size, 0);
  for (int j = 0; j < cells.height; ++j) {
    for (int i = 0; i < cells.width; ++i) {
      // In order of inverse depth.
      std::array<int, 4> child{};
      int n = 0;
      for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
          const int x = 2 * i + a, y = 2 * j + b;
          if (x >= fine.width || y >= fine.height) continue;
          const int c = y * fine.width + x;
          if (fine.count[c] == 0 || !(keep.empty() || keep[c])) continue;
          int k = n++;
          for (; k > 0 && fine.w[child[k - 1]] > fine.w[c]; --k) child[k] = child[k - 1];
          child[k] = c;
        }
      }
      if (n == 0) continue;
      const float reference = fine.w[child[n / 2]];
      float u = 0, v = 0, w = 0, total = 0;
      for (int k = 0; k < n; ++k) {
        if (!continuous(cells, fine.w[child[k]], reference)) continue;
        const float m = static_cast<float>(fine.count[child[k]]);
        u += m * fine.u[child[k]], v += m * fine.v[child[k]], w += m * fine.w[child[k]];
        total += m;
      }
      const int c = j * cells.width + i;
      cells.count[c] = static_cast<int>(total);
      cells.u[c] = u / total, cells.v[c] = v / total, cells.w[c] = w / total;
    }
  }
  return cells;
}

}  // namespace quadrille
