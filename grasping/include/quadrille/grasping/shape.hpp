#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/body.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace quadrille {

/// A convex collision shape of one detection, or of a part of it, clipped to the extent of its
/// inliers.
struct CollisionShape {
  /// Id of the detection.
  int target = 0;
  /// "sphere", "ellipsoid", "cylinder", "cone", "convex" or "box".
  std::string kind;
  /// Pose of the shape's own frame S (FCL's: centred, axis z).
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Sizes in the order of FCL's constructor [m]: sphere r; ellipsoid a b c; cylinder r l; cone r l
  /// (apex at +l/2); box full sides x y z. Convex shapes carry vertices instead.
  std::vector<double> dimensions;
  /// Vertices of a convex shape in frame S, and its faces as (count, indices …) [m].
  std::vector<Eigen::Vector3d> vertices_S;
  std::vector<int> faces;
  /// No point of the shape lies farther than this from what it stands for: the solid, or the patch
  /// of surface where the quadric bounds none, each as far as it was seen [m]. 0 for exact shapes.
  double excess = 0.0;
  std::shared_ptr<fcl::CollisionGeometry<double>> geometry;
};

/// The collision shapes of a detection, which hold all of it within its extent; empty if its type
/// has none (the reason in *why).
///
/// Spheres, ellipsoids, circular cylinders, whole circular cones and parallel planes are exact.
/// Frusta, elliptic cylinders and cones, paraboloids and sheets of hyperboloids are a polyhedron
/// around the body; hyperboloids of one sheet a stack of them, waist left open. A plane is a slab
/// of 10 mm to 100 mm behind the side that was seen, each half of two that meet one of 10 mm;
/// hyperbolic paraboloids, hyperbolic and parabolic cylinders are blocks that reach 10 mm behind.
std::vector<CollisionShape> make_shapes(const Detection& detection, std::string* why = nullptr);

/// Convex shapes whose union holds the body: what a hand must stay out of.
std::vector<CollisionShape> make_pieces(const Body& body);

}  // namespace quadrille
