#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille::experiments {

/// A plane through a point, with the two unit directions that span it.
struct SectionPlane {
  Eigen::Vector3d origin, u, v;

  Eigen::Vector3d at(double a, double b) const { return origin + a * u + b * v; }
};

/// Returns the intersection of a quadric and a plane, within |a| <= half and |b| <= half: pieces of
/// the conic, each from one point (a, b) to the next. The points are exact up to rounding; a branch
/// that turns back within a cell of the grid is missed.
/// @param half  half the side of the square, in the unit of the quadric
/// @param cells  number of cells of the grid along a side
std::vector<std::pair<double, double>> section(const Quadric& Q, const SectionPlane& plane,
                                               double half, int cells = 80);

}  // namespace quadrille::experiments
