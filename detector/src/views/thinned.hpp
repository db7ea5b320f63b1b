#pragma once

#include "quadrille/detector/point_cloud.hpp"
#include "samples/sight.hpp"

namespace quadrille {

/// Leaves out rows and columns of an organised cloud, as long as its pixels stay closer together
/// than planners can tell apart. A cloud of 640x480 pixels keeps a quarter of them. Others stay as
/// they are.
/// @param sight  what the cloud's sensor saw; no cells if that is not known
PointCloud thinned(const PointCloud& cloud, const Sight& sight);

}  // namespace quadrille
