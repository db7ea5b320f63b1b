#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// The collision shapes of a detection, which hold all of it within its extent; empty if its type
/// has none (the reason in *why).
///
/// Spheres, ellipsoids, circular cylinders, whole circular cones and parallel planes are exact.
/// Frusta, elliptic cylinders and cones, paraboloids and sheets of hyperboloids are a polyhedron
/// around the body; hyperboloids of one sheet a stack of them, waist left open. A plane is a slab
/// of 10 mm to 100 mm behind the side that was seen, each half of two that meet one of 10 mm;
/// hyperbolic paraboloids, hyperbolic and parabolic cylinders are blocks that reach 10 mm behind.
QUADRILLE_EXPORT std::vector<CollisionShape> make_shapes(const Detection& detection,
                                                         std::string* why = nullptr);

/// The collision shape of a box: native, of its most likely size. What it may reach beyond lies in
/// space that was not seen.
QUADRILLE_EXPORT CollisionShape make_shape(const Box& box);

}  // namespace quadrille
