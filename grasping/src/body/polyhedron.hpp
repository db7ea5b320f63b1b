#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "body/body.hpp"
#include "quadrille/grasping/collision_shape.hpp"

namespace quadrille {

/// Number of corners of the polygons that stand for ellipses. A radius of 30 mm grows by
/// (sec(π/32) − 1) · 30 mm = 0.145 mm.
inline constexpr int kSides = 32;

/// Cross-section of a polyhedron that encloses a body: its height, and the scale of its semi-axes.
struct Ring {
  double z, s;
};

/// Makes a polyhedron of rings closed by flat ends, with polygons around the ellipses. Its excess
/// is that of the polygons.
CollisionShape make_rings(const Body& body, const std::vector<Ring>& rings);

/// Makes a solid with six faces. Bit 0 of a corner's index tells inner from outer, bits 1 and 2
/// give the corner's place.
CollisionShape make_block(const std::array<Eigen::Vector3d, 8>& corners_S,
                          const Eigen::Isometry3d& X_CS);

}  // namespace quadrille
