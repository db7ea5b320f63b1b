#include "views/seen_through.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

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

Mask cells_seen_through(const Sight& view, const Sight& other) {
  Mask through(view.w.size(), 0);
  std::vector<int> open;
  for (int n = 0; n < static_cast<int>(view.w.size()); ++n) {
    if (view.w[n] == 0.0f) continue;
    through[n] =
        sees_through(other, place_of_cell(view, n % view.width, n / view.width), kWellBehind);
    if (through[n]) open.push_back(n);
  }
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

}  // namespace quadrille
