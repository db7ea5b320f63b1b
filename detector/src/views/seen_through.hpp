#pragma once

#include <Eigen/Core>
#include <span>

#include "base/mask.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// Least distances between a place and all that a view measured along the ray to it [m].
struct Clearance {
  /// Whatever is within this distance beside the ray must lie farther than the place.
  float beside;
  /// By how much it must lie farther.
  float behind;
};

/// Several times the errors of depth and of poses.
inline constexpr Clearance kWellBehind = {0.01f, 0.025f};
/// Close above what a thing stands on, little of what is measured lies well behind. There, and for
/// samples that lie on no surface, it is enough if all lies behind by more than noise.
inline constexpr Clearance kAtFoot = {0.004f, 0.008f};

/// True if a view sees through a place: around it, all that the view measured lies behind. No
/// surface is there; stereo sensors, for example, match what repeats, and see it in the air.
/// @param sight  what the view saw, in the frame of the place
bool sees_through(const Sight& sight, const Eigen::Vector3f& p_C, const Clearance& clearance);

/// Marks the cells of a view that another view sees through by a wide margin, and then neighbours
/// of these that it sees through by a narrow one, which are the feet of things.
/// @param other  what the other view saw, in the same frame
Mask cells_seen_through(const Sight& view, const Sight& other);

/// Marks the points of a view that another view sees through.
/// @param points_C  what the view saw, in frame C [m]
/// @param view      what the view saw, in the same frame; no cells if that is not known
/// @param cells     see cells_seen_through()
/// @param other     what the other view saw, in the same frame
Mask points_seen_through(std::span<const Eigen::Vector3f> points_C, const Sight& view,
                         const Mask& cells, const Sight& other);

/// Marks the points of a view that another view sees through although none of the view's cells
/// shows them: at the border of a thing a cell may show what is behind. The thing's own cells, next
/// to theirs, must be seen through.
/// @param cells  see cells_seen_through(); the other parameters are those of points_seen_through()
Mask border_points_seen_through(std::span<const Eigen::Vector3f> points_C, const Sight& view,
                                const Mask& cells, const Sight& other);

/// Number of marked cells among cell (i, j) of a view and its eight neighbours.
int count_marked_about(const Mask& cells, const Sight& view, int i, int j);

/// The place that a cell of a view shows, in frame C; the cell must have seen something.
Eigen::Vector3f place_of_cell(const Sight& view, int i, int j);

}  // namespace quadrille
