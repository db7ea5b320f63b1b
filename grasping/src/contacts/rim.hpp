#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "body/body.hpp"
#include "contacts/contact_line.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// Bounds of a wall's thickness, which one view does not show [m].
struct WallThickness {
  double min = 0.002, max = 0.008;
};

/// The wall of a hollow body that is open at one end: a cup, a bowl.
struct Shell {
  /// The body whose surface was seen, its z axis out of the mouth, its rim at z_max.
  Body body;
  /// True if the seen surface is the inner one, so that the wall lies outside of it.
  bool seen_inside = false;
  WallThickness wall;

  /// Where the wall may begin and end along the outward normal of the seen surface [m].
  double inner() const { return seen_inside ? 0.0 : -wall.max; }
  double outer() const { return seen_inside ? wall.max : 0.0; }
  /// Distance from the seen surface, negative inside, to first order [m].
  double offset(const Eigen::Vector3d& p_C) const;
  /// True if p_C lies within `margin` [m] of where the wall may be.
  bool in_wall(const Eigen::Vector3d& p_C, double margin) const;
  /// Point of the seen surface at an angle around the axis and height z, in frame Q of the body.
  Eigen::Vector3d point_Q(double angle, double z) const;
  /// Outward unit normal there.
  Eigen::Vector3d normal_Q(double angle, double z) const;
};

/// True if the gradient of the detection's quadric, which points to the side that the sensor saw,
/// points into the body.
bool seen_from_inside(const Detection& detection, const Body& body);

/// The open end of a body; nullopt if it shows none. An end is open if the sensor saw past what
/// lies just below it. Its rim is raised by up to 8 mm to where the points on the wall end. An
/// ellipsoid is cut where the points measured on it end, above the plane that it stands on.
/// @param up_C  unit normal of that plane; zero if none is known
std::optional<Shell> find_shell(const Body& body, bool seen_inside, const PointCloud& cloud,
                                const DepthView& view, const Eigen::Vector3d& up_C,
                                const WallThickness& wall);

/// Contact lines across the wall, all around the rim, some millimetres below it: one pad inside,
/// one outside, each clear of the thickest wall and of its bend within the finger's width, and
/// midway between them a wall of mean thickness.
std::vector<ContactLine> rim_lines(const Shell& shell, const Gripper& gripper);

/// Those of the lines at which enough points of the wall were measured, with the deviation of these
/// points instead of the fit's: near them the wall is known, however badly its far side.
std::vector<ContactLine> measured_lines(const Shell& shell, const std::vector<ContactLine>& lines,
                                        const PointCloud& cloud);

/// Convex shapes whose union holds the wall at its thickest.
std::vector<CollisionShape> make_wall(const Shell& shell);

}  // namespace quadrille
