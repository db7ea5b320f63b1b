#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

#include "boxes/direction_index.hpp"

namespace quadrille {

/// The part of the segment from a to b within a box, as shares of its length from a on (clipped
/// slab by slab); nullopt if there is none.
std::optional<std::pair<double, double>> clip(const Eigen::AlignedBox3d& box,
                                              const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Points that were seen through a box, or in it: so many that it is no solid.
/// @param X_CB  pose of the frame of the box
int count_seen_within(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB,
                      const std::vector<Eigen::Vector3d>& points_C, const DirectionIndex& sight);

/// How far one end of a box may be moved outward before it hides what was seen: the least distance
/// at which a line of sight passes through what was added, but for a few lines. Infinite if none
/// does.
/// @param axis     of frame B, along which the end moves
/// @param side     1 for the upper end, −1 for the lower one
/// @param strays   lines that do not count
double free_of_sight(const Eigen::AlignedBox3d& box_B, const Eigen::Isometry3d& X_CB, int axis,
                     int side, const std::vector<Eigen::Vector3d>& points_C,
                     const DirectionIndex& sight, std::size_t strays);

}  // namespace quadrille
