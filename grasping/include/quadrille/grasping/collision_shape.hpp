#pragma once

#include <memory>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace quadrille {

/// A convex collision shape. It stands for a box, for a detection or for a part of one, and is
/// clipped to the extent of the detection's inliers. Its frame S is that of FCL, and its sizes are
/// in the order of FCL's constructors.
struct CollisionShape : SolidShape {
  /// Id of the detection or box that the shape stands for.
  int target = 0;
  /// The shape nowhere reaches farther than this beyond what it stands for: the solid, or the patch
  /// of surface where the quadric bounds none, each as far as it was seen [m]. 0 for exact shapes.
  double excess = 0.0;
  std::shared_ptr<fcl::CollisionGeometry<double>> geometry;
};

}  // namespace quadrille
