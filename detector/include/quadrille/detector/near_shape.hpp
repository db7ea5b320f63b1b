#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

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
  NearShape(SolidShape&&, double) = delete;

  /// True if a finite point, in the frame of the shape's pose, lies in it or within the distance
  /// [m].
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

}  // namespace quadrille
