#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Corners of the convex hull, counterclockwise (monotone chain). There are at least three unless
/// all points lie on a line or there are none.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

}  // namespace quadrille
