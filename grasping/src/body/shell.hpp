#pragma once

#include <Eigen/Core>
#include <vector>

#include "body/body.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Bounds of a wall's thickness, which one view does not show [m].
struct WallThickness {
  double min = 0.002, max = 0.008;
};

/// Points of a wall lie within this distance of its fitted surface [m], given noise and misfit.
inline constexpr double kWallNoise = 0.004;

/// The wall of a hollow body that is open at one end, such as a cup or a bowl.
struct Shell {
  /// The body whose surface was seen; its z axis points out of the mouth, and its rim lies at
  /// z_max.
  Body body;
  /// True if the seen surface is the inner one, so that the wall lies outside of it.
  bool seen_inside = false;
  WallThickness wall;

  /// Bounds of the wall along the outward normal of the seen surface [m].
  double inner() const { return seen_inside ? 0.0 : -wall.max; }
  double outer() const { return seen_inside ? wall.max : 0.0; }
  /// Distance from the seen surface, negative inside, to first order [m].
  double offset(const Eigen::Vector3d& p_C) const;
  /// Returns true if p_C lies within `margin` [m] of where the wall may be.
  bool in_wall(const Eigen::Vector3d& p_C, double margin) const;
  /// Point of the seen surface at an angle around the axis and height z, in frame Q of the body.
  Eigen::Vector3d point_Q(double angle, double z) const;
  /// Outward unit normal at that point.
  Eigen::Vector3d normal_Q(double angle, double z) const;
};

/// Returns true if the gradient of the detection's quadric, which points to the side that the
/// sensor saw, points into the body.
bool seen_from_inside(const Detection& detection, const Body& body);

/// Makes convex shapes whose union encloses the wall at its thickest.
std::vector<CollisionShape> make_wall(const Shell& shell);

}  // namespace quadrille
