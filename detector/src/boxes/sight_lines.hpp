#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

#include "boxes/direction_index.hpp"

namespace quadrille {

/// The part of the segment from a to b that lies within a box, as fractions of the segment counted
/// from a (clipped slab by slab); nullopt if there is none.
std::optional<std::pair<double, double>> clip(const Eigen::AlignedBox3d& box,
                                              const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Counts the points that were seen through a box or in it; many of them show that it is no solid.
/// @param X_CB  pose of the frame of the box in frame C
std::size_t count_seen_within(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB,
                              const std::vector<Eigen::Vector3d>& points_C,
                              const DirectionIndex& sight);

/// How far one end of a box may be moved outward before it hides what was seen: the least distance
/// at which a line of sight passes through the added part, except for some strays. Infinite if no
/// line does [m].
/// @param axis    axis of frame B along which the end moves
/// @param side    1 for the upper end, −1 for the lower one
/// @param strays  number of lines that are ignored
double free_of_sight(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB, int axis,
                     int side, const std::vector<Eigen::Vector3d>& points_C,
                     const DirectionIndex& sight, std::size_t strays);

}  // namespace quadrille
