#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lab/scene/family.hpp"
#include "lab/scene/random.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// Bodies on a table in front of a wall, and the camera's pose.
struct Layout {
  /// Table, wall, quadrics and boxes; frame W: z up, origin in the middle of the table.
  std::vector<Body> bodies;
  Eigen::Isometry3d X_CW = Eigen::Isometry3d::Identity();
};

/// Draws layouts until the occlusions fit the family; if none fits, takes the nearest one.
Layout find_layout(const FamilyTraits& traits, Random* random);

}  // namespace quadrille::scene
