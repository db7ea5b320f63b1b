#pragma once

#include <string>

#include "quadrille/grasping/grasp_scene.hpp"
#include "view/scene/scene.hpp"

namespace quadrille::view {

/// Makes a scene of what was found in a cloud, without grasps.
/// @param cloud,  result  in the frame K in which the work was done
/// @param X_CK  pose of that frame in the frame C of the scene
Scene scene_of_result(const PointCloud& cloud, const DetectionResult& result,
                      const Eigen::Isometry3d& X_CK);

/// Adds a plan to the scene of its cloud. A further query for each object gives its own grasps and
/// refusals.
/// @param asked  the grasp scene that made the plan
/// @param X_CK  pose of its frame in that of the scene
/// @param limits  limits the voxels of a layer
void add_plan(const GraspScene& asked, const GraspQuery& query, GraspPlan plan,
              const Gripper& gripper, UnknownPolicy unknown, const Eigen::Isometry3d& X_CK,
              const PackLimits& limits, Scene* scene);

}  // namespace quadrille::view
