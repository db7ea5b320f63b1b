#pragma once

#include <Eigen/Core>

namespace quadrille {

/// A point with its unit normal.
struct OrientedPoint {
  Eigen::Vector3d x, n;
};

}  // namespace quadrille
