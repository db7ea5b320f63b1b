#pragma once

#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// The places of things that a newer view shows where an older one saw through, some centimetres
/// apart. Both sights are in frame C, like the places [m].
std::vector<Eigen::Vector3f> put_down(const Sight& newer, const Sight& older);

/// Drops what a newer view shows to be gone or hidden by something new: the points of an older
/// cloud that it sees through, and those to which a ray of the older view passes by a place where
/// something was put down.
/// @param older    what the older view saw, in frame C
/// @param newer    what the newer view saw, in frame C
/// @param places   put_down() of both
/// @param cloud    the older cloud, in frame C
void drop_outdated(const Sight& older, const Sight& newer,
                   const std::vector<Eigen::Vector3f>& places, PointCloud* cloud);

}  // namespace quadrille
