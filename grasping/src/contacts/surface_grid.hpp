#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "body/body.hpp"

namespace quadrille {

/// Points all over the surface of a body, coordinate by coordinate, to see what hands of many
/// orientations would reach.
struct SurfaceGrid {
  static constexpr std::size_t kHeights = 9, kAngles = 16, kPoints = kHeights * kAngles;
  std::array<double, kPoints> x, y, z;
};

/// Returns points on the surface in frame C [m], around its axis at several heights.
SurfaceGrid surface_grid(const Body& body);

/// Turns points into the axes of an orientation; the origin stays that of C.
void turn_points(const SurfaceGrid& points_C, const Eigen::Matrix3d& R_CG, SurfaceGrid* points_G);

/// The bounds of some points along x and y [m].
struct GridBounds {
  double x_min, x_max, y_min, y_max;
};

/// Returns the bounds of the points whose z is at most `deep` beyond `nearest` [m].
GridBounds bounds_within(const SurfaceGrid& points, double deep, double nearest);

/// The least and the greatest of some values.
struct GridSpan {
  double least, greatest;
};

/// Returns the span of one coordinate of all points.
GridSpan span_of(const std::array<double, SurfaceGrid::kPoints>& values);

}  // namespace quadrille
