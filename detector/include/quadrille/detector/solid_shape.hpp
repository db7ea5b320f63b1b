#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

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
  std::vector<double> dimensions = {};
  /// Vertices of a convex shape in frame S, and its faces as (count, indices …) [m].
  std::vector<Eigen::Vector3d> vertices_S = {};
  std::vector<int> faces = {};

  /// @throws std::invalid_argument if the fields are not finite, not positive, or make no such
  /// shape
  QUADRILLE_EXPORT void check() const;
};

}  // namespace quadrille
