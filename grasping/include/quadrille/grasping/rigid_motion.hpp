#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// A grasp of frame C in frame F.
QUADRILLE_EXPORT Grasp moved(Grasp grasp, const Eigen::Isometry3d& X_FC);

/// A collision shape of frame C in frame F.
QUADRILLE_EXPORT CollisionShape moved(CollisionShape shape, const Eigen::Isometry3d& X_FC);

/// All of a plan of frame C in frame F but its map of space, which stays in frame C: see
/// OccupancyGrid::moved().
QUADRILLE_EXPORT GraspPlan moved(GraspPlan plan, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
