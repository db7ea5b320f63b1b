#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace quadrille {

/// A convex collision shape. It stands for a box, for a detection or for a part of one, and is
/// clipped to the extent of the detection's inliers.
struct CollisionShape {
  /// Id of the detection or box that the shape stands for.
  int target = 0;
  /// "sphere", "ellipsoid", "cylinder", "cone", "convex" or "box".
  std::string kind;
  /// Pose of the shape's own frame S, which is FCL's: centred, with the axis along z.
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Sizes in the order of FCL's constructor [m]: sphere r; ellipsoid a b c; cylinder r l; cone r l
  /// (apex at +l/2); box full sides x y z. Convex shapes carry vertices instead.
  std::vector<double> dimensions;
  /// Vertices of a convex shape in frame S, and its faces as (count, indices …) [m].
  std::vector<Eigen::Vector3d> vertices_S;
  std::vector<int> faces;
  /// The shape nowhere reaches farther than this beyond what it stands for: the solid, or the patch
  /// of surface where the quadric bounds none, each as far as it was seen [m]. 0 for exact shapes.
  double excess = 0.0;
  std::shared_ptr<fcl::CollisionGeometry<double>> geometry;
};

}  // namespace quadrille
