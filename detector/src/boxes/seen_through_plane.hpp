#pragma once

#include <Eigen/Core>

namespace quadrille {

/// A point that was seen through a place in a face's plane.
struct SeenThrough {
  /// The seen point, the intersection of its line of sight with the plane, and the point's height
  /// over the plane, positive on the side of the eye [m].
  Eigen::Vector3d p_C, on_C;
  double height = 0.0;
};

}  // namespace quadrille
