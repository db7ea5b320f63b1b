#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lab/scene/family.hpp"
#include "lab/scene/random.hpp"
#include "lab/scene/surface.hpp"

namespace quadrille::scene {

/// Bodies on a table in front of a wall, and where the camera looks from.
struct Layout {
  /// Table, wall, quadrics, boxes; frame W: z up, origin in the middle of the table.
  std::vector<Body> bodies;
  Eigen::Isometry3d X_CW = Eigen::Isometry3d::Identity();
};

/// Draws layouts until one hides as much as suits the family; else takes the nearest one.
Layout find_layout(const FamilyTraits& traits, Random* random);

}  // namespace quadrille::scene
