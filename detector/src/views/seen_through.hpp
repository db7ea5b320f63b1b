#pragma once

#include <Eigen/Core>

#include "base/mask.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// How far from a place all must be that a view measured along the ray to it [m]. The distances are
/// several times the errors of depth and of poses.
struct Clearance {
  /// Whatever is within this distance beside the ray must lie farther than the place.
  float beside = 0.01f;
  /// By how much it must lie farther.
  float behind = 0.025f;
};

/// True if a view sees through a place: around it, all that the view measured lies well behind. No
/// surface is there; stereo sensors, for example, match what repeats, and see it in the air.
/// @param sight  what the view saw, in the frame of the place
bool sees_through(const Sight& sight, const Eigen::Vector3f& p_C, const Clearance& clearance = {});

/// Marks the cells of a view of which another view sees through the place that they show.
/// @param other  what the other view saw, in the same frame
Mask cells_seen_through(const Sight& view, const Sight& other);

/// Marks the points of a view that another view sees through.
/// @param cloud  points in frame C
/// @param view   what the view saw, in the same frame; no cells if that is not known
/// @param cells  the cells whose points are to be tested, which saves most of the tests; points
///   without a cell are tested too
/// @param other  what the other view saw, in the same frame
Mask points_seen_through(const PointCloud& cloud, const Sight& view, const Mask& cells,
                         const Sight& other, const Clearance& clearance = {});

/// The place that a cell of a view shows, in frame C; the cell must have seen something.
Eigen::Vector3f place_of_cell(const Sight& view, int i, int j);

}  // namespace quadrille
