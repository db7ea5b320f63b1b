#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// A convex solid at a pose.
struct SolidShape {
  /// "sphere", "ellipsoid", "cylinder", "capsule", "cone", "box" or "convex".
  std::string kind;
  /// Pose of the shape's own frame S, which is centred, with the axis along z.
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Sizes [m]: sphere r; ellipsoid a b c; cylinder r l; capsule r l, where l is the length between
  /// the middles of its round ends; cone r l (apex at +l/2); box full sides x y z. Convex shapes
  /// carry vertices instead.
  std::vector<double> dimensions;
  /// Vertices of a convex shape in frame S, and its faces as (count, indices …) [m].
  std::vector<Eigen::Vector3d> vertices_S;
  std::vector<int> faces;

  /// @throws std::invalid_argument if the fields are not finite, not positive, or make no such
  /// shape
  QUADRILLE_EXPORT void check() const;
};

/// Tells which points lie in a shape, or within a distance of it.
///
/// The distance is exact for all but two kinds, which are a little larger than they would be if it
/// were: the sides and the base of a cone move outward by it, and so do the faces of a convex
/// shape, so that their edges stay sharp.
class NearShape {
 public:
  /// @param shape     has passed check(), and must outlive this
  /// @param distance  at least 0 [m]
  QUADRILLE_EXPORT NearShape(const SolidShape& shape, double distance);

  QUADRILLE_EXPORT bool contains(const Eigen::Vector3d& p_C) const;
  /// Bounds of the shape and the space about it [m].
  const Eigen::AlignedBox3d& bounds_C() const { return bounds_C_; }

 private:
  const SolidShape& shape_;
  double distance_;
  Eigen::Isometry3d X_SC_;
  Eigen::AlignedBox3d bounds_C_;
  /// Outward unit normals of the faces of a convex shape, as rows, and their offsets [m].
  Eigen::Matrix<double, Eigen::Dynamic, 3> normals_S_;
  Eigen::VectorXd offsets_;
};

/// The robot's own shapes when a cloud was taken: its links, its hand, and what that holds.
struct RobotShapes {
  std::vector<SolidShape> shapes;
  /// A point within this distance of a shape is the robot's, because shapes and poses are a little
  /// wrong [m].
  double padding = 0.01;

  /// Returns the cloud without the robot's points, which become NaN.
  QUADRILLE_EXPORT PointCloud taken_from(PointCloud cloud) const;

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

/// Transforms a robot's shapes from frame C into frame F.
QUADRILLE_EXPORT RobotShapes moved(RobotShapes robot, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
