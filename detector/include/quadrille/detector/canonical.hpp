#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// A quadric in its own frame: its type, pose and size.
struct CanonicalForm {
  QuadricType type = QuadricType::kPlane;
  /// Pose of the canonical frame Q in the frame of the quadric. The origin is the centre of
  /// surfaces that have one, the apex of a cone, or the vertex of a paraboloid. The z axis is the
  /// axis of revolution, the axis of a cylinder, cone or hyperboloid, the direction in which a
  /// paraboloid opens, or a plane's normal; otherwise a ≥ b (≥ c) along x, y (, z).
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  /// Names and values in the order of Detection::dimensions, without lengths along axes, which a
  /// quadric does not have. Lengths are in the unit of the coordinates, angles in radians.
  std::vector<std::pair<std::string, double>> dimensions;
};

/// True if a dimension of that name is an angle and not a length.
QUADRILLE_EXPORT bool is_angle(const std::string& dimension);

/// Finds type, pose and dimensions from the eigenvalues of Q and of its upper left 3x3 block. It
/// tells apart all 17 types and the circular special cases.
///
/// It is most accurate in coordinates in which the surface has about unit size.
/// @param tolerance  relative size below which an eigenvalue, a constant or a difference of
///   semi-axes counts as zero
/// @throws std::invalid_argument if Q is zero, not finite, or a constant
QUADRILLE_EXPORT CanonicalForm canonical_form(const Quadric& Q, double tolerance = 1e-9);

/// Makes the quadric of a canonical form, the inverse of canonical_form() up to scale.
/// @throws std::invalid_argument for imaginary types, which have no dimensions
QUADRILLE_EXPORT Quadric from_canonical(const CanonicalForm& form);

}  // namespace quadrille
