#pragma once

#include <string>

#include "quadrille/grasping/grasp_scene.hpp"
#include "view/scene.hpp"

namespace quadrille::view {

/// What was found in a cloud, without any grasps.
/// @param cloud, result  in the frame K that was worked in
/// @param X_CK           that frame in the frame C of the scene
Scene scene_of_result(const PointCloud& cloud, const DetectionResult& result,
                      const Eigen::Isometry3d& X_CK);

/// Adds a plan to the scene of its cloud; each object is also asked for alone, for its own grasps
/// and refusals.
/// @param asked   what the plan was made of
/// @param X_CK    its frame in that of the scene
/// @param limits  most voxels of one layer
void add_plan(const GraspScene& asked, const GraspQuery& query, GraspPlan plan,
              const Gripper& gripper, UnknownPolicy unknown, const Eigen::Isometry3d& X_CK,
              const PackLimits& limits, Scene* scene);

}  // namespace quadrille::view
