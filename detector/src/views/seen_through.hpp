#pragma once

#include <Eigen/Core>

#include "base/mask.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// True if a view sees through a place: around it, all that the view measured lies well behind. No
/// surface is there; stereo sensors, for example, match what repeats, and see it in the air.
/// @param sight  what the view saw, in the frame of the place
bool sees_through(const Sight& sight, const Eigen::Vector3f& p_C);

/// Marks the cells of a view of which another view sees through the place that they show.
/// @param other  what the other view saw, in the same frame
Mask cells_seen_through(const Sight& view, const Sight& other);

/// Marks the points of a view that another view sees through.
/// @param cloud  points in frame C
/// @param view   what the view saw, in the same frame, which saves most of the tests; no cells if
///   that is not known
/// @param other  what the other view saw, in the same frame
Mask points_seen_through(const PointCloud& cloud, const Sight& view, const Sight& other);

/// The place that a cell of a view shows, in frame C; the cell must have seen something.
Eigen::Vector3f place_of_cell(const Sight& view, int i, int j);

}  // namespace quadrille
