#pragma once

#include <Eigen/Geometry>

#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// A grasp of frame C in frame F.
Grasp moved(Grasp grasp, const Eigen::Isometry3d& X_FC);

/// A collision shape of frame C in frame F.
CollisionShape moved(CollisionShape shape, const Eigen::Isometry3d& X_FC);

/// All of a plan of frame C in frame F but its map of space, which stays in frame C: see
/// OccupancyGrid::moved().
GraspPlan moved(GraspPlan plan, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
