#pragma once

#include "lab/scene/random.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// Makes a random quadric body that stands or lies on z = 0 of its frame B.
/// @param scale  factor on sizes of 6 to 25 cm
Body random_quadric(double scale, Random* random);

/// Makes a random box that stands on z = 0 of its frame B.
Body random_box(double scale, Random* random);

/// Makes a box with these half sides along x, y, z that stands on z = 0 of its frame B.
Body make_box(const Eigen::Vector3d& half);

/// Makes a circular cylinder with both ends that stands on z = 0 of its frame B; its surfaces are
/// side, end, end.
Body make_cylinder(double radius, double length);

/// Makes an ellipsoid with these semi-axes along x, y, z (a sphere if they are equal) that touches
/// z = 0 of its frame B.
Body make_ball(const Eigen::Vector3d& axes);

/// Makes the four thin walls of a rectangular tray that stands on z = 0.
Body make_tray(double half_x, double half_y, double height);

/// Makes the table: the rectangle |x| <= half_x, |y| <= half_y of z = 0.
Body make_table(double half_x, double half_y);

/// Makes a wall, 3 m high, in the plane y = 0 of its frame B, seen from y < 0.
Body make_wall();

}  // namespace quadrille::scene
