#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Points of a body lie within this distance of it, given noise and misfit [m].
inline constexpr double kBodyNoise = 0.006;

/// The solid that a detected quadric bounds, including its hidden side, in its canonical frame Q.
///
/// Each cross-section at height z is an ellipse with semi-axes a·s(z) along x and b·s(z) along y,
/// where z runs from z_min to z_max. For boxes and parallel planes it is a rectangle of half sizes
/// a and b.
struct Body {
  /// Upper limit of all standard deviations: anything less certain counts as not known at all [m].
  static constexpr double kMaxStd = 0.01;

  /// How the scale s varies along z.
  enum class Profile {
    kConstant,   ///< cylinders: s = 1
    kLinear,     ///< cones: s = |z|
    kRoot,       ///< elliptic paraboloids: s = √z
    kHyperbola,  ///< hyperboloids of one sheet: s = √(1 + z²/c²)
    kSheet,      ///< one of a hyperboloid's two sheets: s = √(z²/c² − 1) for z ≥ c
    kEllipse,    ///< ellipsoids: s = √(1 − z²/c²)
    kBox,        ///< boxes, and parallel planes between their extents
  };

  Profile profile = Profile::kConstant;
  Eigen::Isometry3d X_CQ = Eigen::Isometry3d::Identity();
  /// Semi-axes at s = 1 [m]. For kLinear they are tangents of the half angles; for kRoot their unit
  /// is √m.
  double a = 0.0, b = 0.0;
  /// Third semi-axis of kHyperbola, kSheet and kEllipse [m].
  double c = 0.0;
  double z_min = 0.0, z_max = 0.0;
  /// Standard deviations of a, b and c, in their units.
  Eigen::Vector3d std = Eigen::Vector3d::Zero();
  /// Standard deviation of each end, z_min and z_max [m].
  double end_std = 0.0;
  /// Distance by which the body extends beyond the extent of its detection, up to the apex of a
  /// cone [m].
  double beyond = 0.0;

  /// The scale s(z) and its derivative.
  double scale(double z) const;
  double slope(double z) const;
  /// Standard deviation of half the width across unit direction d_Q at height z, at most 10 mm [m].
  /// Each semi-axis contributes according to the direction: h² = Σ aᵢ²dᵢ², so dh = Σ aᵢdᵢ²·daᵢ/h.
  double width_std(const Eigen::Vector3d& d_Q, double z) const;
  /// Standard deviation of the angle by which the surface leans from the axis at height z, given
  /// those of the semi-axes [rad]; 0 for cylinders and boxes, which lean nowhere, and for
  /// ellipsoids.
  double lean_std(double z) const;
  /// A lower bound of width_std() across a direction at all heights: exact for cylinders and
  /// ellipsoids, otherwise 0 [m].
  double least_width_std(const Eigen::Vector3d& d_Q) const;
  /// Half sizes of the bounding box along x and y at the widest cross-section [m].
  Eigen::Vector2d widest() const;
  /// Bounding box in frame Q [m].
  Eigen::AlignedBox3d bounds_Q() const;
  /// Bounding box in frame C [m].
  Eigen::AlignedBox3d bounds_C() const;
  /// Centre of the bounding box, in frame C [m].
  Eigen::Vector3d centre_C() const { return X_CQ * bounds_Q().center(); }
  /// Returns true if p_C lies within the body grown by `margin` [m] (along its semi-axes and ends).
  bool contains(const Eigen::Vector3d& p_C, double margin = 0.0) const {
    return contains_Q(X_CQ.inverse() * p_C, margin);
  }
  /// True if the body contains a point of frame Q, as contains() has it for a point of frame C.
  bool contains_Q(const Eigen::Vector3d& p_Q, double margin) const;
};

/// Returns the same body with its z axis reversed.
Body turned(Body body);

/// Makes the solid of a box at its largest possible size.
Body make_body(const Box& box);

/// Makes the solid of a detection; nullopt if its type bounds none, or its size is not finite and
/// positive.
std::optional<Body> make_body(const Detection& detection);

}  // namespace quadrille
