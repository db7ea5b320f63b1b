#include "views/seen_through.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

// Share of the rays there that must have measured something.
constexpr float kMinMeasured = 0.8f;

/// The cell of a view that a place projects to; nullopt if it is none.
std::optional<std::size_t> cell_of(const Sight& sight, const Eigen::Vector3f& p_C) {
  const Eigen::Vector3f p = sight.X_VC * p_C;
  const Eigen::Array2f at = (p.head<2>().array() / p.z() - sight.corner) / sight.step;
  const Eigen::Array2f size(static_cast<float>(sight.width), static_cast<float>(sight.height));
  if (!(p.z() > 0.0f && (at >= 0.0f).all() && (at < size).all())) return std::nullopt;
  return static_cast<std::size_t>(at.y()) * sight.width + static_cast<std::size_t>(at.x());
}

/// A row of a view's cells, and how they project into another view.
struct RowGeometry {
  /// A cell's place times its inverse depth, in the other view's frame: that of the row's first
  /// cell were it infinitely far away, what each further cell adds, and what each 1/m adds.
  Eigen::Array3f first, along, nearer;
  /// See Sight.
  Eigen::Array2f corner;
  float inverse_step, width, height;
  /// The distance by which places are moved away [m].
  float behind;
};

/// Projects the places of a row of cells into the other view.
/// @param w        inverse depths of the row's cells [1/m]
/// @param index    receives the other view's cell for each cell; −1 if there is none
/// @param moved_w  receives the inverse depth of each moved place in the other view [1/m]
QUADRILLE_VECTOR_CLONES
void project_row(const RowGeometry& row, const float* w, int size, int* index, float* moved_w) {
  const float x0 = row.first[0], y0 = row.first[1], z0 = row.first[2];
  const float dx = row.along[0], dy = row.along[1], dz = row.along[2];
  const float nx = row.nearer[0], ny = row.nearer[1], nz = row.nearer[2];
  const float u0 = row.corner[0], v0 = row.corner[1], inverse_step = row.inverse_step;
  const float width = row.width, height = row.height, behind = row.behind;
  for (int i = 0; i < size; ++i) {
    const float n = static_cast<float>(i);
    const float x = x0 + n * dx + w[i] * nx;
    const float y = y0 + n * dy + w[i] * ny;
    const float z = z0 + n * dz + w[i] * nz;
    const float u = (x / z - u0) * inverse_step, v = (y / z - v0) * inverse_step;
    const bool inside =
        (w[i] > 0.0f) & (z > 0.0f) & (u >= 0.0f) & (v >= 0.0f) & (u < width) & (v < height);
    const int column = static_cast<int>(inside ? u : 0.0f);
    const int line = static_cast<int>(inside ? v : 0.0f);
    index[i] = inside ? line * static_cast<int>(width) + column : -1;
    moved_w[i] = w[i] / (z + behind * w[i]);
  }
}

/// Calls visit(n) for each cell of a view that another view may see through: the one cell of the
/// other view onto which it projects lies farther away than the cell, by the clearance.
template <class Visit>
void each_maybe_seen_through(const Sight& view, const Sight& other, const Clearance& clearance,
                             const Visit& visit) {
  const Eigen::Isometry3f X_OV = other.X_VC * view.X_VC.inverse();
  RowGeometry row{{},
                  view.step * X_OV.linear().col(0).array(),
                  X_OV.translation().array(),
                  other.corner,
                  1.0f / other.step,
                  static_cast<float>(other.width),
                  static_cast<float>(other.height),
                  clearance.behind};
  // Rounding does not hide a cell that is seen through.
  constexpr float kRounding = 1.0f + 1e-4f;
  std::vector<int> index(static_cast<std::size_t>(view.width));
  std::vector<float> moved_w(index.size());
  for (int j = 0; j < view.height; ++j) {
    const Eigen::Vector3f tangent(view.corner.x() + 0.5f * view.step,
                                  view.corner.y() + (static_cast<float>(j) + 0.5f) * view.step,
                                  1.0f);
    row.first = X_OV.linear() * tangent;
    const float* const w = &view.w[static_cast<std::size_t>(j) * view.width];
    project_row(row, w, view.width, index.data(), moved_w.data());
    for (int i = 0; i < view.width; ++i) {
      const int of_other = index[i];
      if (of_other >= 0 && other.w[of_other] <= kRounding * moved_w[i]) visit(j * view.width + i);
    }
  }
}

}  // namespace

bool sees_through(const Sight& sight, const Eigen::Vector3f& p_C, const Clearance& clearance) {
  if (sight.w.empty()) return false;
  const Eigen::Vector3f p = sight.X_VC * p_C;
  if (!(p.z() > 0.0f)) return false;
  const float reach = clearance.beside / p.z();
  const Eigen::Array2f at = p.head<2>().array() / p.z() - sight.corner;
  const Eigen::Array2f first = ((at - reach) / sight.step).floor();
  const Eigen::Array2f last = ((at + reach) / sight.step).floor();
  const Eigen::Array2f size(static_cast<float>(sight.width), static_cast<float>(sight.height));
  if (!((first >= 0.0f).all() && (last < size).all())) return false;
  const float farthest = 1.0f / (p.z() + clearance.behind);
  int measured = 0, all = 0;
  for (int j = static_cast<int>(first.y()); j <= static_cast<int>(last.y()); ++j) {
    const auto row = sight.w.begin() + static_cast<std::ptrdiff_t>(j) * sight.width;
    for (int i = static_cast<int>(first.x()); i <= static_cast<int>(last.x()); ++i) {
      if (row[i] > farthest) return false;
      measured += row[i] > 0.0f;
      ++all;
    }
  }
  return static_cast<float>(measured) >= kMinMeasured * static_cast<float>(all);
}

Eigen::Vector3f place_of_cell(const Sight& view, int i, int j) {
  const float w = view.w[static_cast<std::size_t>(j) * view.width + i];
  const Eigen::Array2f middle(static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f);
  const Eigen::Array2f tangent = view.corner + view.step * middle;
  return view.X_VC.inverse() * Eigen::Vector3f(tangent.x() / w, tangent.y() / w, 1.0f / w);
}

int count_marked_about(const Mask& cells, const Sight& view, int i, int j) {
  int count = 0;
  for (int y = std::max(j - 1, 0); y <= std::min(j + 1, view.height - 1); ++y) {
    for (int x = std::max(i - 1, 0); x <= std::min(i + 1, view.width - 1); ++x) {
      count += cells[static_cast<std::size_t>(y) * view.width + x];
    }
  }
  return count;
}

Mask cells_seen_through(const Sight& view, const Sight& other) {
  Mask through(view.w.size(), 0);
  std::vector<int> open;
  if (other.w.empty()) return through;
  each_maybe_seen_through(view, other, kWellBehind, [&](int n) {
    through[n] =
        sees_through(other, place_of_cell(view, n % view.width, n / view.width), kWellBehind);
    if (through[n]) open.push_back(n);
  });
  while (!open.empty()) {
    const int n = open.back();
    open.pop_back();
    const int u = n % view.width, v = n / view.width;
    for (const auto& [i, j] : {std::pair(u - 1, v), {u + 1, v}, {u, v - 1}, {u, v + 1}}) {
      if (i < 0 || j < 0 || i >= view.width || j >= view.height) continue;
      const int next = j * view.width + i;
      if (through[next] || view.w[next] == 0.0f) continue;
      through[next] = sees_through(other, place_of_cell(view, i, j), kAtFoot);
      if (through[next]) open.push_back(next);
    }
  }
  return through;
}

Mask points_seen_through(std::span<const Eigen::Vector3f> points_C, const Sight& view,
                         const Mask& cells, const Sight& other) {
  const bool none = !cells.empty() && std::find(cells.begin(), cells.end(), 1) == cells.end();
  Mask through(points_C.size(), 0);
  if (none) return through;
  for (std::size_t n = 0; n < through.size(); ++n) {
    const Eigen::Vector3f& p_C = points_C[n];
    const std::optional<std::size_t> cell = cell_of(view, p_C);
    // Without a cell nothing is known of what is connected with the point.
    through[n] = cell ? cells[*cell] && sees_through(other, p_C, kAtFoot)
                      : sees_through(other, p_C, kWellBehind);
  }
  return through;
}

Mask border_points_seen_through(std::span<const Eigen::Vector3f> points_C, const Sight& view,
                                const Mask& cells, const Sight& other) {
  Mask through(points_C.size(), 0);
  if (std::find(cells.begin(), cells.end(), 1) == cells.end()) return through;
  for (std::size_t n = 0; n < through.size(); ++n) {
    const Eigen::Vector3f& p_C = points_C[n];
    const std::optional<std::size_t> cell = cell_of(view, p_C);
    if (!cell) continue;
    const int k = static_cast<int>(*cell);
    if (count_marked_about(cells, view, k % view.width, k / view.width) == 0) continue;
    const float depth = (view.X_VC * p_C).z(), w = view.w[*cell];
    const bool shown = std::abs(depth * w - 1.0f) <= kWellBehind.behind * w;
    through[n] = !shown && sees_through(other, p_C, kWellBehind);
  }
  return through;
}

}  // namespace quadrille
