#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/body.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace quadrille {

/// A collision shape of one detection, clipped to the extent of its inliers.
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
  std::shared_ptr<fcl::CollisionGeometry<double>> geometry;
};

/// The collision shape of a detection; nullopt if its type has none (the reason in *why).
///
/// Spheres, ellipsoids, circular cylinders and whole circular cones are exact. Frusta, elliptic
/// cylinders and cones and paraboloids are polyhedra that hold the body; so are hyperboloids of one
/// sheet, waist filled. A plane is a slab of 10 mm to 100 mm behind the side that was seen.
std::optional<CollisionShape> make_shape(const Detection& detection, std::string* why = nullptr);

/// Convex shapes whose union is the body itself, waist left open: what a hand must stay out of.
std::vector<CollisionShape> make_pieces(const Body& body);

}  // namespace quadrille
