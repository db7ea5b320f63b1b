#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Makes collision shapes that enclose a detection within its extent. Returns none if its type has
/// no real surface, or its size is not finite and positive.
///
/// Spheres, ellipsoids, circular cylinders, whole circular cones and parallel planes are exact.
/// Frusta, elliptic cylinders and cones, paraboloids and sheets of hyperboloids become a polyhedron
/// around the body. A hyperboloid of one sheet becomes a stack of polyhedra that leaves the waist
/// open. A plane becomes a slab of 10 mm to 100 mm behind the side that was seen, and each half of
/// two intersecting planes a slab of 10 mm. Hyperbolic paraboloids, hyperbolic and parabolic
/// cylinders become blocks that reach 10 mm behind the surface.
QUADRILLE_EXPORT std::vector<CollisionShape> make_shapes(const Detection& detection);

/// Makes the collision shape of a box: a native box of its most likely size. Anything beyond that
/// size lies in space that was not seen.
QUADRILLE_EXPORT CollisionShape make_shape(const Box& box);

/// Makes the collision shape of a solid that the caller knows, as of shapes that are read from a
/// file.
/// @throws std::invalid_argument if its fields make no such solid
QUADRILLE_EXPORT CollisionShape with_geometry(SolidShape solid);

}  // namespace quadrille
