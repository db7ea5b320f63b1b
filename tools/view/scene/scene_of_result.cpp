#include "view/scene/scene_of_result.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille::view {
namespace {

Rejected counts_of(const GraspPlan& plan) { return {plan.rejected.begin(), plan.rejected.end()}; }

std::vector<int> ids_of(const Scene& scene) {
  std::vector<int> ids;
  for (const Detection& d : scene.detections) {
    if (d.type != QuadricType::kPlane) ids.push_back(d.id);
  }
  for (const Box& box : scene.boxes) ids.push_back(box.id);
  return ids;
}

/// Adds the refusals of each object, and its grasps if those of other objects had displaced all of
/// them from the list.
void ask_for_each(const GraspScene& asked, GraspQuery query, const std::vector<int>& ids,
                  GraspPlan* plan, Scene* scene) {
  constexpr int kMaxGrasps = 20;
  std::set<int> listed;
  for (const Grasp& grasp : plan->grasps) listed.insert(grasp.target);
  query.max_grasps = kMaxGrasps;
  for (const int id : ids) {
    query.ids = {id};
    GraspPlan own = asked.plan(query);
    scene->rejected_of[id] = counts_of(own);
    if (listed.contains(id)) continue;
    plan->grasps.insert(plan->grasps.end(), own.grasps.begin(), own.grasps.end());
  }
}

void add_new(const std::vector<std::string>& lines, std::vector<std::string>* all) {
  for (const std::string& line : lines) {
    if (std::find(all->begin(), all->end(), line) == all->end()) all->push_back(line);
  }
}

}  // namespace

Scene scene_of_result(const PointCloud& cloud, const DetectionResult& result,
                      const Eigen::Isometry3d& X_CK) {
  Scene scene;
  scene.cloud = moved(cloud, X_CK);
  scene.detections = moved(result.detections, X_CK);
  std::erase_if(scene.detections, [](const Detection& d) { return !is_reported(d); });
  scene.boxes = moved(result.boxes, X_CK);
  std::erase_if(scene.boxes, [](const Box& box) { return !is_reported(box); });
  scene.timings = {{"detect", result.total_ms}};
  scene.warnings = result.warnings;
  return scene;
}

void add_plan(const GraspScene& asked, const GraspQuery& query, GraspPlan plan,
              const Gripper& gripper, UnknownPolicy unknown, const Eigen::Isometry3d& X_CK,
              const PackLimits& limits, Scene* scene) {
  scene->gripper = gripper;
  scene->gripper_name = gripper.name;
  scene->unknown = unknown;
  scene->rejected = counts_of(plan);
  ask_for_each(asked, query, ids_of(*scene), &plan, scene);
  for (const Grasp& grasp : plan.grasps) scene->grasps.push_back(moved(grasp, X_CK));
  scene->timings.push_back({"plan", plan.total_ms});
  add_new(plan.warnings, &scene->warnings);
  if (!plan.space) return;
  const bool moves = !X_CK.matrix().isIdentity(0.0);
  scene->voxels = layers_of(moves ? plan.space->moved(X_CK) : *plan.space, limits.voxels);
}

}  // namespace quadrille::view
