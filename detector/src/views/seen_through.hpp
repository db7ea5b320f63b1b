#pragma once

#include <span>

#include "base/mask.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// Marks the points of a view that another view sees through: around each of them, all that the
/// other view measured lies well behind. No surface is there; stereo sensors, for example, match
/// what repeats, and see it in the air.
/// @param cloud   points in frame C
/// @param others  what the other views saw, in the same frame
Mask seen_through(const PointCloud& cloud, std::span<const Sight> others);

}  // namespace quadrille
