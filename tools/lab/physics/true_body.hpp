#pragma once

#include <Eigen/Geometry>
#include <string>

namespace quadrille::physics {

/// A true object of a generated scene: a box, or the solid that a quadric bounds between two flat
/// ends, in its own frame S. Each cross-section at height z is an ellipse with semi-axes a·s(z) and
/// b·s(z), s² = p₂z² + p₁z + p₀: spheres to hyperboloids alike, and without the library's names for
/// them.
struct TrueBody {
  int id = 0;
  std::string type;
  Eigen::Isometry3d X_CS = Eigen::Isometry3d::Identity();
  /// Where it is [m]; for a box all that there is to know.
  Eigen::AlignedBox3d box_S;
  bool is_box = false;
  /// The truth says that enough of it is seen for it to be found.
  bool is_seen = false;
  double a = 0.0, b = 0.0;
  /// p₀, p₁, p₂.
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  /// Which flat ends are missing, at z_min and z_max.
  bool open_low = false, open_high = false;
  /// Thickness of the wall of a body with an end that is open to above; 0 for what is solid, or
  /// hollow only from below [m].
  double wall = 0.0;
  /// Where the middle of the wall lies, outward from the surface [m].
  double wall_at = 0.0;

  double z_min() const { return box_S.min().z(); }
  double z_max() const { return box_S.max().z(); }
  /// s(z), 0 where there is no cross-section.
  double scale(double z) const;
  /// True if no straight line between two of its points leaves it (of hollow ones, if filled).
  bool is_convex() const;
  /// True if p_C lies in it (in hollow ones, as if they were filled).
  bool contains(const Eigen::Vector3d& p_C) const;
  /// A point of the surface at an angle around the axis, and the outward unit normal there.
  Eigen::Vector3d point_S(double angle, double z) const;
  Eigen::Vector3d normal_S(double angle, double z) const;
};

/// Mass, centre and moments of inertia about the centre, along the axes of S.
struct MassProperties {
  double mass = 0.0;
  Eigen::Vector3d centre_S = Eigen::Vector3d::Zero();
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
};

/// Of a homogeneous body; hollow ones weigh as much as if they were filled, as a cup with something
/// in it does.
/// @param density  [kg/m³]
MassProperties mass_properties(const TrueBody& body, double density);

/// The point of the section z_0 ≤ z ≤ z_1 that lies farthest in a direction: with half the width
/// h = √(a²dx² + b²dy²) the largest s(z)·h + z·dz, at an end or where its derivative vanishes.
/// Exact for convex bodies.
Eigen::Vector3d support_point(const TrueBody& body, double z_0, double z_1,
                              const Eigen::Vector3d& direction_S);

}  // namespace quadrille::physics
