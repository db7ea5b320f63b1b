#include "view/scene/scene_of_cloud.hpp"

#include <utility>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille::view {

Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup) {
  DetectionResult found = detect(cloud, setup.detector);
  const GraspScene asked(cloud, found.detections, setup.gripper, setup.plan, {}, found.boxes,
                         found.bodies);
  const GraspQuery query = moved(completed(setup.query, setup.plan), X_CK.inverse());
  GraspPlan plan = asked.plan(query);
  found.boxes = plan.boxes;
  Scene scene = scene_of_result(cloud, found, X_CK);
  add_plan(asked, query, std::move(plan), setup.gripper, setup.plan.unknown, X_CK, setup.limits,
           &scene);
  return scene;
}

}  // namespace quadrille::view
