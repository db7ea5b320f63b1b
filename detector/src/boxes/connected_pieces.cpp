#include "boxes/connected_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Upper limit of grid cells per point. If a few points lie far from all others, the cells are made
// larger to keep it.
constexpr double kMaxCellsPerPoint = 64.0;

constexpr int kEmpty = -2, kOpen = -1;

}  // namespace

std::vector<int> connected_pieces(const std::vector<Eigen::Vector2d>& places, double cell) {
  if (places.empty()) return {};
  Eigen::AlignedBox2d bounds;
  for (const Eigen::Vector2d& place : places) bounds.extend(place);
  const double max_cells = kMaxCellsPerPoint * static_cast<double>(places.size());
  cell = std::max(
      {cell, std::sqrt(bounds.sizes().prod() / max_cells), bounds.sizes().maxCoeff() / max_cells});
  // A border of empty cells gives each cell all eight neighbours.
  const int width = 3 + static_cast<int>(bounds.sizes().x() / cell);
  const int height = 3 + static_cast<int>(bounds.sizes().y() / cell);
  std::vector<int> cells;
  cells.reserve(places.size());
  std::vector<int> piece(static_cast<std::size_t>(width) * height, kEmpty);
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2i at = ((place - bounds.min()) / cell).cast<int>();
    cells.push_back((at.y() + 1) * width + at.x() + 1);
    piece[cells.back()] = kOpen;
  }
  int next = 0;
  std::vector<int> open;
  for (int seed = 0; seed < static_cast<int>(piece.size()); ++seed) {
    if (piece[seed] != kOpen) continue;
    piece[seed] = next;
    open = {seed};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (int n = 0; n < 9; ++n) {
        const int neighbour = at + (n / 3 - 1) * width + n % 3 - 1;
        if (piece[neighbour] != kOpen) continue;
        piece[neighbour] = next;
        open.push_back(neighbour);
      }
    }
    ++next;
  }
  for (int& at : cells) at = piece[at];
  return cells;
}

}  // namespace quadrille
