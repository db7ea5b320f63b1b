#pragma once

#include "quadrille/detector/options.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "view/log_backend.hpp"

namespace quadrille::view {

/// With what the clouds of a log are worked on.
struct PlanSetup {
  DetectorOptions detector;
  PlanOptions plan;
  Gripper gripper;
  GraspQuery query;
  PackLimits limits;
};

/// Detects and plans on one cloud, as `quadrille plan` does. Each object is also asked for alone,
/// for its own grasps and refusals.
/// @param cloud  in the frame K to work in
/// @param X_CK   that frame in the frame C of the scene
Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup);

}  // namespace quadrille::view
