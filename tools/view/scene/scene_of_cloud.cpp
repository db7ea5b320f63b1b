#include "view/scene/scene_of_cloud.hpp"

#include <utility>

#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "view/scene/scene_of_result.hpp"

namespace quadrille::view {

Scene scene_of_detections(const PointCloud& cloud, DetectionResult found,
                          std::vector<PointCloud> views, const Eigen::Isometry3d& X_CK,
                          const PlanSetup& setup) {
  Surroundings known;
  known.robot = moved(setup.robot, X_CK.inverse());
  known.views = std::move(views);
  const GraspScene asked(cloud, found.detections, setup.gripper, setup.plan, known, found.boxes,
                         found.bodies);
  const GraspQuery query = moved(completed(setup.query, setup.plan), X_CK.inverse());
  GraspPlan plan = asked.plan(query);
  found.boxes = plan.boxes;
  Scene scene = scene_of_result(cloud, found, X_CK);
  add_plan(asked, query, std::move(plan), setup.gripper, setup.plan.unknown, X_CK, setup.limits,
           &scene);
  scene.robot = setup.robot.shapes;
  return scene;
}

Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup) {
  const RobotShapes robot_K = moved(setup.robot, X_CK.inverse());
  return scene_of_detections(cloud, detect(robot_K.taken_from(cloud), setup.detector), {}, X_CK,
                             setup);
}

}  // namespace quadrille::view
