#include "view/scene/scene_of_result.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille::view {
namespace {

/// Adds the refusals of each target, and its grasps if those of other targets had displaced all of
/// them from the list.
void add_targets(const GraspScene& asked, GraspQuery query, GraspPlan* plan, Scene* scene) {
  constexpr int kMaxGrasps = 20;
  std::set<int> listed;
  for (const Grasp& grasp : plan->grasps) listed.insert(grasp.target);
  query.max_grasps = kMaxGrasps;
  for (const TargetOutcome& outcome : plan->targets) {
    Rejected& rejected = scene->rejected_of[outcome.target];
    for (const auto& [why, count] : outcome.refusals) rejected[std::string(to_string(why))] = count;
    if (outcome.grasps == 0 || listed.contains(outcome.target)) continue;
    query.ids = {outcome.target};
    const GraspPlan own = asked.plan(query);
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
  scene.lumps = lumps_of(moved(result.bodies, X_CK));
  scene.sightings = sightings_of(result.bodies);
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
  scene->rejected = {plan.rejected.begin(), plan.rejected.end()};
  scene->remedies = plan.remedies;
  for (const Look& look : plan.looks) {
    scene->looks.push_back({X_CK * look.X_CK, look.bodies, look.gain});
  }
  add_targets(asked, query, &plan, scene);
  for (const Grasp& grasp : plan.grasps) scene->grasps.push_back(moved(grasp, X_CK));
  scene->timings.push_back({"plan", plan.total_ms});
  add_new(plan.warnings, &scene->warnings);
  if (!plan.space) return;
  const bool moves = !X_CK.matrix().isIdentity(0.0);
  scene->voxels = layers_of(moves ? plan.space->moved(X_CK) : *plan.space, limits.voxels);
}

}  // namespace quadrille::view
