#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "grasping/fuzz/hostile_detections.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/hostile_cloud.hpp"

namespace quadrille::test {

inline GraspQuery hostile_query(Choices& choices) {
  GraspQuery query;
  if (choices.one_in(4)) query.ids = {static_cast<int>(choices.below(4))};
  if (choices.one_in(4)) query.near_C = Eigen::Vector3d(choices.hostile(), 0.0, 1.0);
  if (choices.one_in(4)) query.min_size = choices.hostile();
  if (choices.one_in(4)) query.min_clearance = choices.hostile();
  if (choices.one_in(4)) query.approach = Cone{{0.0, 0.0, choices.hostile()}, choices.hostile()};
  if (choices.one_in(4)) {
    query.reach = Reach{{choices.hostile(), 0.0, 1.0}, choices.hostile(), choices.hostile()};
  }
  if (choices.one_in(4)) query.min_score = choices.hostile();
  if (choices.one_in(4)) query.per_target = static_cast<int>(choices.below(40));
  if (choices.one_in(4)) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(choices.hostile());
    query.region = Region{Eigen::Isometry3d::Identity(), {-half, half}};
  }
  return query;
}

inline PlanOptions hostile_options(Choices& choices) {
  PlanOptions options;
  options.unknown = choices.pick(
      std::array{UnknownPolicy::kFree, UnknownPolicy::kTargetShadow, UnknownPolicy::kObstacle});
  options.resolution = choices.pick(std::array{0.01, 0.02, 0.05, 0.005});
  options.clear_above = !choices.one_in(4);
  if (choices.one_in(16)) options.friction = choices.hostile();
  if (choices.one_in(16)) options.approach = choices.hostile();
  if (choices.one_in(16)) options.pad_margin = choices.hostile();
  return options;
}

inline void require_sound(const GraspPlan& plan) {
  for (const Grasp& grasp : plan.grasps) {
    if (!grasp.X_CG.matrix().allFinite() || !grasp.X_CG.linear().isUnitary(1e-2)) {
      throw std::logic_error("a grasp's pose is none");
    }
    if (!std::isfinite(grasp.score)) throw std::logic_error("a grasp's score is no number");
  }
}

/// Whatever cloud, detections and query are, the planner gives a sound plan, or refuses options or
/// a query that are out of range.
inline GraspPlan plan_hostile(Choices& choices) {
  const Gripper gripper = choices.one_in(3) ? robotiq_2f140() : franka_hand();
  const PlanOptions options = hostile_options(choices);
  const bool asks = choices.one_in(4), detects = choices.one_in(4), two_views = choices.one_in(4);
  const GraspQuery query = asks ? hostile_query(choices) : GraspQuery();
  const SmallScene scene = small_scene(choices);
  const PointCloud sane = scene.render();
  std::vector<Detection> detections = detects ? detect(sane).detections : scene.truth();
  spoil(choices, &detections);
  const PointCloud cloud = CloudSpoiler(choices, sane).spoil();
  std::vector<PointCloud> further;
  if (two_views) further.push_back(CloudSpoiler(choices, sane).spoil());
  GraspPlan plan;
  try {
    plan = plan_grasps(cloud, detections, gripper, options, {further}, query);
  } catch (const std::invalid_argument&) {
    bool in_range = true;
    try {
      options.check();
      query.check();
    } catch (const std::invalid_argument&) {
      in_range = false;
    }
    if (in_range) throw std::logic_error("refused options and a query in range");
  }
  require_sound(plan);
  return plan;
}

}  // namespace quadrille::test
