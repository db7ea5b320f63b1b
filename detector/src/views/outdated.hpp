#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// Drops what a newer view contradicts: the points of an older cloud that it sees through, and,
/// where it shows something new, the points to which the older view's rays passed close by. The
/// older view knows nothing of what is behind a new thing, or hidden in it.
/// @param older  what the older view saw, in frame C
/// @param newer  what the newer view saw, in frame C
/// @param cloud  the older cloud, in frame C
void drop_outdated(const Sight& older, const Sight& newer, PointCloud* cloud);

/// Drops the points of a cloud in a box, and those that its sensor saw through the box, which is
/// then unknown.
/// @param box_R  the box, in its frame R [m]
/// @param X_RC   pose of the cloud's frame C in R
void drop_seen_in(const Eigen::AlignedBox3f& box_R, const Eigen::Isometry3f& X_RC,
                  PointCloud* cloud);

}  // namespace quadrille
