#include "process/planner/pair_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille {
namespace {

/// Returns the query with the obstacles of the settings, and their directions and reach unless it
/// has its own.
/// @param query  query in the camera's frame
GraspQuery with_conditions(GraspQuery query, const PlannerSettings& settings,
                           const Placement& placement) {
  GraspQuery given;
  given.approach = settings.approach;
  given.obstacles = settings.obstacles;
  given = completed(std::move(given), settings.plan);
  if (placement.X_WK) given = moved(std::move(given), placement.X_WK->inverse());
  if (!query.approach) query.approach = given.approach;
  if (!query.reach) query.reach = given.reach;
  query.obstacles = std::move(given.obstacles);
  return query;
}

/// A cloud and what was found in it, in the camera's frame K.
struct Things {
  PointCloud cloud;
  std::vector<Detection> detections;
  std::optional<std::vector<Box>> boxes;
  std::vector<SceneBody> bodies;
};

Things things_in_camera(const CloudAndQuadrics& pair, const PlannerSettings& settings) {
  const Placement& placement = pair.placement;
  const bool as_results = pair.quadrics.frame == placement.frame;
  const Eigen::Isometry3d X_KF = (as_results ? placement.X_RK : placement.X_CK).inverse();
  Things things{in_camera_frame(pair.cloud->cloud, placement, settings.frames),
                moved(pair.quadrics.detections, X_KF), pair.others.boxes,
                moved(pair.others.bodies, X_KF)};
  if (things.boxes) things.boxes = moved(*std::move(things.boxes), X_KF);
  if (!placement.lack.empty()) {
    things.cloud.viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return things;
}

}  // namespace

/// Plans on a pair in the camera's frame. The scene is made unless it is that of the last call.
GraspPlan PairPlanner::plan_in_camera(const SharedPair& pair, const GraspQuery& query,
                                      bool advise) {
  if (pair == ready_ && !advise) return scene_->plan(query);
  const Things things = things_in_camera(*pair, settings_);
  PlanOptions options = settings_.plan;
  options.deadline_ms = *query.deadline_ms;
  // Whatever throws from here on leaves no scene that a later query could take for another one.
  ready_ = nullptr;
  scene_.emplace(things.cloud, things.detections, settings_.gripper, options,
                 std::vector<PointCloud>{}, things.boxes, things.bodies);
  GraspPlan plan = scene_->plan_from_start(query);
  // A scene that was cut short may lack targets, so the next query for this cloud makes a new one.
  if (!plan.cut) ready_ = pair;
  if (advise) {
    plan.remedies = find_remedies(plan, things.cloud, things.detections, settings_.gripper, options,
                                  {}, query, things.boxes, things.bodies);
  }
  return plan;
}

GraspPlan PairPlanner::plan(const SharedPair& pair, const GraspQuery& query, bool advise) {
  GraspQuery timed = with_conditions(query, settings_, pair->placement);
  timed.deadline_ms = query.deadline_ms.value_or(settings_.plan.deadline_ms);
  GraspPlan plan = plan_in_camera(pair, timed, advise);
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
