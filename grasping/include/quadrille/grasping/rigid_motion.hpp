#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// Transforms a grasp from frame C into frame F.
QUADRILLE_EXPORT Grasp moved(Grasp grasp, const Eigen::Isometry3d& X_FC);

/// Transforms a collision shape from frame C into frame F.
QUADRILLE_EXPORT CollisionShape moved(CollisionShape shape, const Eigen::Isometry3d& X_FC);

/// Transforms a plan from frame C into frame F, except its map of space, which stays in frame C:
/// see OccupancyGrid::moved().
QUADRILLE_EXPORT GraspPlan moved(GraspPlan plan, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
