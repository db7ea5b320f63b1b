#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "view/log/log_backend.hpp"

namespace quadrille::view {

/// The settings with which the clouds of a log are processed.
struct PlanSetup {
  DetectorOptions detector;
  PlanOptions plan;
  Gripper gripper;
  /// The query, in the frame C of the scene.
  GraspQuery query;
  /// The robot's own shapes, in C.
  RobotShapes robot;
  PackLimits limits;
};

/// Plans on what was detected in a cloud, as `quadrille plan` does. A further query for each object
/// gives its own grasps and refusals.
/// @param cloud  cloud in the frame K in which the work is done
/// @param found  what was detected in the cloud and in earlier views, in K
/// @param views  what earlier views saw, in K
/// @param X_CK  pose of that frame in the frame C of the scene
Scene scene_of_detections(const PointCloud& cloud, DetectionResult found,
                          std::vector<PointCloud> views, const Eigen::Isometry3d& X_CK,
                          const PlanSetup& setup);

/// Detects and plans on one cloud alone.
/// @param cloud  cloud in the frame K in which the work is done
/// @param X_CK  pose of that frame in the frame C of the scene
Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup);

}  // namespace quadrille::view
