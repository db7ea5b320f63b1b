#pragma once

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Standard deviation of the cloud's points about a detected surface, across it, from the median of
/// their distances (first-order, to the quadric) [m]. Counts points within 15 mm of the surface, so
/// it is at most 22 mm; 0 if there are none. Of a large cloud a part of the points is looked at.
double point_noise(const Detection& detection, const PointCloud& cloud);

}  // namespace quadrille
