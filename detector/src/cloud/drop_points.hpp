#pragma once

#include "base/mask.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Drops the marked points of a cloud; those of an organised one become NaN.
void drop_points(const Mask& dropped, PointCloud* cloud);

}  // namespace quadrille
