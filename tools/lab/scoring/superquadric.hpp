#pragma once

#include <Eigen/Geometry>
#include <array>

namespace quadrille::scoring {

/// The value of a superquadric's gauge at a point, with its derivatives.
struct Gauge {
  double value = 0.0;
  /// With respect to the point, in the superquadric's frame.
  Eigen::Vector3d by_point = Eigen::Vector3d::Zero();
  /// With respect to ε₁ and ε₂.
  Eigen::Vector2d by_exponents = Eigen::Vector2d::Zero();
};

/// A superquadric with convex interior, the surface
///   (|x/a₁|^(2/ε₂) + |y/a₂|^(2/ε₂))^(ε₂/ε₁) + |z/a₃|^(2/ε₁) = 1
/// of its frame S. Exponents near 0 make edges; 1 is round, and 2 gives flat faces between the
/// axes. An ellipsoid has ε = (1, 1), a cylinder nearly (0, 1), and a box nearly (0, 0).
///
/// If F is the left side, F^(ε₁/2) is the gauge of the body: the factor by which the body must be
/// scaled about its centre to reach a point. It grows in proportion along each ray from the centre.
struct Superquadric {
  /// ε₁ of the profile along z, and ε₂ of the section across it; each above 0 and at most 2.
  Eigen::Vector2d exponents = Eigen::Vector2d::Ones();
  /// Semi-axes a along x, y, z of S [m].
  Eigen::Vector3d axes = Eigen::Vector3d::Ones();
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();

  /// Returns the gauge at a point of frame S; its derivatives are 0 in planes x, y or z = 0 as far
  /// as they do not exist there.
  Gauge gauge(const Eigen::Vector3d& p_S) const;

  /// Returns gauge − 1, which is negative within the body, and its gradient in frame C [1/m]. Their
  /// ratio is the first-order distance.
  double value(const Eigen::Vector3d& p_C) const;
  Eigen::Vector3d gradient(const Eigen::Vector3d& p_C) const;

  /// Returns the values of t at which the line o + t d crosses the surface, the smaller value
  /// first; both are NaN if it does not.
  /// @param d  unit direction
  std::array<double, 2> crossings(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const;
};

}  // namespace quadrille::scoring
