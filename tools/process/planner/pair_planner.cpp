#include "process/planner/pair_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille {
namespace {

/// Returns the query with the directions and the reach of the settings, unless it has its own.
/// @param query  query in the camera's frame
GraspQuery with_conditions(GraspQuery query, const PlannerSettings& settings,
                           const Placement& placement) {
  GraspQuery given;
  given.approach = settings.approach;
  given = completed(std::move(given), settings.plan);
  if (placement.X_WK) given = moved(std::move(given), placement.X_WK->inverse());
  if (!query.approach) query.approach = given.approach;
  if (!query.reach) query.reach = given.reach;
  return query;
}

}  // namespace

/// Plans on a pair in the camera's frame. The scene is made unless it is that of the last call.
GraspPlan PairPlanner::plan_in_camera(const SharedPair& pair, const GraspQuery& query) {
  if (pair == ready_) return scene_->plan(query);
  const Placement& placement = pair->placement;
  PointCloud cloud_K = in_camera_frame(pair->cloud->cloud, placement, settings_.frames);
  if (!placement.lack.empty()) {
    cloud_K.viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  const bool as_results = pair->quadrics.frame == placement.frame;
  const Eigen::Isometry3d& X_FK = as_results ? placement.X_RK : placement.X_CK;
  PlanOptions options = settings_.plan;
  options.deadline_ms = *query.deadline_ms;
  // Whatever throws from here on leaves no scene that a later query could take for another one.
  ready_ = nullptr;
  std::optional<std::vector<Box>> boxes = pair->others.boxes;
  if (boxes) boxes = moved(std::move(*boxes), X_FK.inverse());
  scene_.emplace(cloud_K, moved(pair->quadrics.detections, X_FK.inverse()), settings_.gripper,
                 options, std::vector<PointCloud>{}, std::move(boxes),
                 moved(pair->others.bodies, X_FK.inverse()));
  GraspPlan plan = scene_->plan_from_start(query);
  // A scene that was cut short may lack targets, so the next query for this cloud makes a new one.
  if (!plan.cut) ready_ = pair;
  return plan;
}

GraspPlan PairPlanner::plan(const SharedPair& pair, const GraspQuery& query) {
  GraspQuery timed = with_conditions(query, settings_, pair->placement);
  timed.deadline_ms = query.deadline_ms.value_or(settings_.plan.deadline_ms);
  GraspPlan plan = plan_in_camera(pair, timed);
  if (plan.cut) {
    ++cut_;
    cut_log_.warning(fmt::format(
        "cloud {}: the deadline cut the plan; it has the grasps that were found until then",
        pair->cloud->utime));
  }
  const Placement& placement = pair->placement;
  if (!placement.lack.empty()) {
    plan.warnings.push_back("the camera's pose is not known: " + placement.lack);
  }
  // If nothing was found, warnings about the cloud are the likely reason.
  if (pair->quadrics.detections.empty()) {
    for (const std::string& warning : pair->quadrics.warnings) {
      const bool known =
          std::find(plan.warnings.begin(), plan.warnings.end(), warning) != plan.warnings.end();
      if (!known) plan.warnings.push_back(warning);
    }
  }
  return moved(std::move(plan), placement.X_RK);
}

}  // namespace quadrille
