#pragma once

#include <set>
#include <vector>

#include "grasping/scenes.hpp"
#include "quadrille/grasping/plan.hpp"
#include "support/catch.hpp"

namespace quadrille::test {

inline PlanOptions with(UnknownPolicy policy) {
  PlanOptions options;
  options.unknown = policy;
  return options;
}

/// The table and the balls on it, with ids from 1 on.
inline std::vector<Detection> detections_of(const std::vector<Ball>& balls) {
  std::vector<Detection> detections = {table_detection()};
  for (const Ball& ball : balls) {
    detections.push_back(sphere_detection(ball, static_cast<int>(detections.size())));
  }
  return detections;
}

inline GraspPlan plan_balls(const std::vector<Ball>& balls, const PlanOptions& options = {},
                            const Gripper& gripper = franka_hand()) {
  return plan_grasps(render(balls), detections_of(balls), gripper, options);
}

/// The grasps on detections without a cloud of theirs, in free space, with a camera at the origin.
inline GraspPlan plan_alone(const std::vector<Detection>& detections) {
  PointCloud cloud;  // far beside it
  for (int i = 0; i < 50; ++i) cloud.points.emplace_back(3.0f, 0.01f * i, 3.0f);
  return plan_grasps(cloud, detections, franka_hand(), with(UnknownPolicy::kFree));
}

inline std::set<int> targets_of(const GraspPlan& plan) {
  std::set<int> ids;
  for (const Grasp& grasp : plan.grasps) ids.insert(grasp.target);
  return ids;
}

/// Checks that two plans have the same grasps to the last bit.
inline void check_same_grasps(const GraspPlan& a, const GraspPlan& b) {
  REQUIRE(a.grasps.size() == b.grasps.size());
  for (std::size_t n = 0; n < a.grasps.size(); ++n) {
    CHECK(a.grasps[n].target == b.grasps[n].target);
    CHECK(a.grasps[n].X_CG.matrix() == b.grasps[n].X_CG.matrix());
    CHECK(a.grasps[n].score == b.grasps[n].score);
    CHECK(a.grasps[n].clearance == b.grasps[n].clearance);
  }
}

}  // namespace quadrille::test
