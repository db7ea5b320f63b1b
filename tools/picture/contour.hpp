#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "picture/sketch.hpp"

namespace quadrille {

/// A grid of points over a part of the picture, `step` pixels apart.
struct ContourGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double step = 3.0;
  int columns = 0, rows = 0;

  Eigen::Vector2d at(int column, int row) const {
    return origin + step * Eigen::Vector2d(column, row);
  }
};

/// Traces the lines along which a function of the picture's points jumps. On each edge of the grid
/// whose ends differ, the jump is located by bisection; within a cell these points are joined.
/// @param values  values at the grid's points, row by row
/// @param value  the value at any point
/// @param differ  whether two values lie on different sides of a jump
/// @param nearer  whether the first value lies on the side of the second one rather than of the
/// third
template <class Value>
std::vector<Segment> trace_contours(
    const ContourGrid& grid, const std::vector<Value>& values,
    const std::function<Value(const Eigen::Vector2d&)>& value,
    const std::function<bool(const Value&, const Value&)>& differ,
    const std::function<bool(const Value&, const Value&, const Value&)>& nearer) {
  constexpr int kHalvings = 6;
  const auto at = [&](int column, int row) -> const Value& {
    return values[static_cast<std::size_t>(row) * grid.columns + column];
  };
  std::vector<Segment> segments;
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const int corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
      std::vector<Eigen::Vector2d> crossings;
      for (int edge = 0; edge < 4; ++edge) {
        const int c0 = column + corners[edge][0], r0 = row + corners[edge][1];
        const int c1 = column + corners[edge + 1][0], r1 = row + corners[edge + 1][1];
        const Value &first = at(c0, r0), &last = at(c1, r1);
        if (!differ(first, last)) continue;
        Eigen::Vector2d from = grid.at(c0, r0), to = grid.at(c1, r1);
        for (int n = 0; n < kHalvings; ++n) {
          const Eigen::Vector2d middle = 0.5 * (from + to);
          (nearer(value(middle), first, last) ? from : to) = middle;
        }
        crossings.push_back(0.5 * (from + to));
      }
      if (crossings.size() == 2) {
        segments.push_back({crossings[0], crossings[1]});
      } else if (crossings.size() > 2) {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& p : crossings) middle += p / double(crossings.size());
        for (const Eigen::Vector2d& p : crossings) segments.push_back({p, middle});
      }
    }
  }
  return segments;
}

}  // namespace quadrille
