#pragma once

#include <Eigen/Geometry>
#include <string>

namespace quadrille::physics {

/// A true object of a generated scene: a box, or the solid that a quadric bounds between two flat
/// ends, in its own frame S. Each cross-section at height z is an ellipse with semi-axes a·s(z) and
/// b·s(z), s² = p₂z² + p₁z + p₀. This covers all quadrics from spheres to hyperboloids, without the
/// library's names for them.
struct TrueBody {
  int id = 0;
  std::string type;
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Bounds of the object [m]; they describe a box completely.
  Eigen::AlignedBox3d box_S;
  bool is_box = false;
  /// True if, according to the ground truth, enough of the object is visible for it to be found.
  bool is_seen = false;
  double a = 0.0, b = 0.0;
  /// The coefficients p₀, p₁, p₂.
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  /// Whether the flat end at z_min or at z_max is missing.
  bool open_low = false, open_high = false;
  /// Thickness of the wall of a body that is open at the top; 0 for solid bodies, and for those
  /// that are open only from below [m].
  double wall = 0.0;
  /// Offset of the middle of the wall, outward from the surface [m].
  double wall_at = 0.0;

  double z_min() const { return box_S.min().z(); }
  double z_max() const { return box_S.max().z(); }
  /// The scale s(z); 0 where there is no cross-section.
  double scale(double z) const;
  /// True if every straight line between two points of the body stays inside it; hollow bodies
  /// count as filled.
  bool is_convex() const;
  /// True if p_C lies inside the body; hollow bodies count as filled.
  bool contains(const Eigen::Vector3d& p_C) const;
  /// Point of the surface at an angle around the axis, and the outward unit normal there.
  Eigen::Vector3d point_S(double angle, double z) const;
  Eigen::Vector3d normal_S(double angle, double z) const;
};

/// Mass, centre and moments of inertia about the centre, along the axes of S.
struct MassProperties {
  double mass = 0.0;
  Eigen::Vector3d centre_S = Eigen::Vector3d::Zero();
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
};

/// Returns the properties of a homogeneous body. Hollow bodies weigh as much as if they were
/// filled, like a cup with something in it.
/// @param density  [kg/m³]
MassProperties mass_properties(const TrueBody& body, double density);

/// Returns the point of the section z_0 ≤ z ≤ z_1 that lies farthest in a direction. It maximises
/// s(z)·h + z·dz with half the width h = √(a²dx² + b²dy²), at an end or where the derivative
/// vanishes. Exact for convex bodies.
Eigen::Vector3d support_point(const TrueBody& body, double z_0, double z_1,
                              const Eigen::Vector3d& direction_S);

}  // namespace quadrille::physics
