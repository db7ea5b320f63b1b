#include "view/scene_of_cloud.hpp"

#include <algorithm>
#include <set>

#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/rigid_motion.hpp"
#include "quadrille/grasping/grasp_scene.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille::view {
namespace {

Rejected counts_of(const GraspPlan& plan) { return {plan.rejected.begin(), plan.rejected.end()}; }

/// Adds the refusals of each object, and those of its grasps that others drove off the list.
void ask_for_each(const GraspScene& asked, const std::vector<int>& ids, GraspPlan* plan,
                  Scene* scene) {
  constexpr int kMaxGrasps = 20;
  std::set<int> listed;
  for (const Grasp& grasp : plan->grasps) listed.insert(grasp.target);
  for (const int id : ids) {
    GraspQuery query;
    query.ids = {id};
    query.max_grasps = kMaxGrasps;
    GraspPlan own = asked.plan(query);
    scene->rejected_of[id] = counts_of(own);
    if (listed.contains(id)) continue;
    plan->grasps.insert(plan->grasps.end(), own.grasps.begin(), own.grasps.end());
  }
}

std::vector<int> ids_of(const Scene& scene) {
  std::vector<int> ids;
  for (const Detection& d : scene.detections) {
    if (d.type != QuadricType::kPlane) ids.push_back(d.id);
  }
  for (const Box& box : scene.boxes) ids.push_back(box.id);
  return ids;
}

/// All in frame C.
void move_all(const Eigen::Isometry3d& X_CK, const OccupancyGrid* space, std::size_t max_voxels,
              Scene* scene) {
  const bool moves = !X_CK.matrix().isIdentity(0.0);
  scene->cloud = moved(std::move(scene->cloud), X_CK);
  scene->detections = moved(std::move(scene->detections), X_CK);
  scene->boxes = moved(std::move(scene->boxes), X_CK);
  for (Grasp& grasp : scene->grasps) grasp = moved(grasp, X_CK);
  if (space == nullptr) return;
  scene->voxels = layers_of(moves ? space->moved(X_CK) : *space, max_voxels);
}

}  // namespace

Scene scene_of_cloud(const PointCloud& cloud, const Eigen::Isometry3d& X_CK,
                     const PlanSetup& setup) {
  DetectionResult found = detect_quadrics(cloud, setup.detector);
  // What quadrille-grasp-planner would get, so that both plan the same grasps.
  const std::vector<Detection> detections = bus::as_received(found.detections);
  const GraspScene asked(cloud, detections, setup.gripper, setup.plan);
  GraspPlan plan = asked.plan();
  Scene scene;
  scene.cloud = cloud;
  scene.detections = detections;
  std::erase_if(scene.detections, [](const Detection& d) { return !is_reported(d); });
  scene.boxes = plan.boxes;
  std::erase_if(scene.boxes, [](const Box& box) { return !is_reported(box); });
  scene.gripper = setup.gripper;
  scene.gripper_name = setup.gripper.name;
  scene.unknown = setup.plan.unknown;
  scene.rejected = counts_of(plan);
  ask_for_each(asked, ids_of(scene), &plan, &scene);
  scene.grasps = plan.grasps;
  scene.timings = {{"detect", found.total_ms}, {"plan", plan.total_ms}};
  scene.warnings = found.warnings;
  for (const std::string& warning : plan.warnings) {
    const bool known =
        std::find(scene.warnings.begin(), scene.warnings.end(), warning) != scene.warnings.end();
    if (!known) scene.warnings.push_back(warning);
  }
  move_all(X_CK, plan.space.get(), setup.max_voxels, &scene);
  return scene;
}

}  // namespace quadrille::view
