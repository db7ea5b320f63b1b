#pragma once

#include "lab/scene/random.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// A random quadric body standing or lying on z = 0 of its frame B.
/// @param scale  factor on sizes of 6 to 25 cm
Body random_quadric(double scale, Random* random);

/// A random box standing on z = 0 of its frame B.
Body random_box(double scale, Random* random);

/// A round cylinder with both ends, standing on z = 0 of its frame B: surfaces side, end, end.
Body make_cylinder(double radius, double length);

/// An ellipsoid of semi-axes along x, y, z, or a sphere where they are equal, that touches z = 0 of
/// its frame B.
Body make_ball(const Eigen::Vector3d& axes);

/// The four thin walls of a rectangular tray, standing on z = 0.
Body make_tray(double half_x, double half_y, double height);

/// The table: the rectangle |x| <= half_x, |y| <= half_y of z = 0.
Body make_table(double half_x, double half_y);

/// A wall, 3 m high, in the plane y = 0 of its frame B, seen from y < 0.
Body make_wall();

}  // namespace quadrille::scene
