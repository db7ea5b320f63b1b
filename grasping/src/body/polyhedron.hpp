#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "body/body.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Corners of the polygons that stand for ellipses: (sec(π/32) − 1) of 30 mm are 0.145 mm.
inline constexpr int kSides = 32;

/// Cross-section of a polyhedron that holds a body: height, and the scale of its semi-axes.
struct Ring {
  double z, s;
};

/// Rings closed by flat ends, its polygons around the ellipses. The excess is that of the polygons.
CollisionShape make_rings(const Body& body, const std::vector<Ring>& rings);

/// A solid of six faces. Bit 0 of a corner's index tells inner from outer, bits 1 and 2 the places.
CollisionShape make_block(const std::array<Eigen::Vector3d, 8>& corners_S,
                          const Eigen::Isometry3d& X_CS);

}  // namespace quadrille
