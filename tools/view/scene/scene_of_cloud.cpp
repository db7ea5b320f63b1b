#include "view/scene/scene_of_cloud.hpp"

#include <utility>

#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille::view {

Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup) {
  DetectionResult found = detect(cloud, setup.detector);
  // Detections are rounded as quadrille-grasp-planner would receive them, so that both plan the
  // same grasps.
  found.detections = bus::as_received(found.detections);
  const GraspScene asked(cloud, found.detections, setup.gripper, setup.plan, {},
                         bus::as_received(found.boxes), bus::as_received(found.bodies));
  const GraspQuery query = moved(completed(setup.query, setup.plan), X_CK.inverse());
  GraspPlan plan = asked.plan(query);
  found.boxes = plan.boxes;
  Scene scene = scene_of_result(cloud, found, X_CK);
  add_plan(asked, query, std::move(plan), setup.gripper, setup.plan.unknown, X_CK, setup.limits,
           &scene);
  return scene;
}

}  // namespace quadrille::view
