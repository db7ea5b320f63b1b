#pragma once

#include <cstddef>
#include <vector>

#include "quadrille/detector/pinhole.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// A grid of cells over the image of a view.
struct CellGrid {
  /// Tangents of the corner left of and above which no point lies, and cells per unit of the
  /// tangents.
  float u0, v0, per_unit;
  int width, height;
};

/// Sums over the points of each cell: their number, tangents and inverse depths, and the extremes
/// of the latter. Behind the last cell are some empty ones, so that vectors may read past it.
struct CellSums {
  std::vector<float> n, u, v, w, min_w, max_w;

  explicit CellSums(std::size_t cells);
};

/// Adds the points that a view looks at to the sums of their cells.
/// @param of_point  receives the cell of each, −1 if unseen; as many as are looked at, rounded up
///                  to a multiple of SeenPoints::kSize
void add_points(const CloudView& cloud, const PinholeView& view, const CellGrid& grid,
                int* of_point, CellSums* sums);

}  // namespace quadrille
