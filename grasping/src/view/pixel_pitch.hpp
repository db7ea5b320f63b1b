#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace quadrille {

/// A grid of pixels in the tangent plane z = 1: pixel k is centred at phase + k·pitch.
struct PixelGrid {
  Eigen::Vector2d pitch = Eigen::Vector2d::Ones();
  Eigen::Vector2d phase = Eigen::Vector2d::Zero();
};

/// Recovers the sensor's grid from points in row order; failing that, a grid coarse enough that
/// most pixels on a surface hold a point. Whatever the points are, no pixel is finer than any
/// camera's, and the grid over the bounds has some four million pixels at most.
/// @param tangents  x/z and y/z of the points in stored order, not empty
/// @param bounds    their bounding box
PixelGrid find_pixel_grid(const std::vector<Eigen::Vector2d>& tangents,
                          const Eigen::AlignedBox2d& bounds);

}  // namespace quadrille
