#include "process/planner/pair_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "process/runtime/logging.hpp"
#include "process/runtime/poses/placed_cloud.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/looks.hpp"
#include "quadrille/grasping/remedies.hpp"
#include "quadrille/grasping/rigid_motion.hpp"

namespace quadrille {
namespace {

/// Returns the query with what is known of obstacles, and the settings' directions and reach unless
/// it has its own.
/// @param query  query in the camera's frame
GraspQuery with_conditions(GraspQuery query, const PlannerSettings& settings, const Known& known,
                           const Placement& placement) {
  GraspQuery given;
  given.approach = settings.approach;
  given = completed(std::move(given), settings.plan);
  if (placement.X_WK) given = moved(std::move(given), placement.X_WK->inverse());
  if (!query.approach) query.approach = given.approach;
  if (!query.reach) query.reach = given.reach;
  query.obstacles = known.obstacles;
  query.attached = known.attached;
  return query;
}

bool are_same(const RobotShapes& a, const RobotShapes& b) {
  return a.padding == b.padding &&
         std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                    [](const SolidShape& x, const SolidShape& y) {
                      return x.kind == y.kind && x.dimensions == y.dimensions &&
                             x.vertices_S == y.vertices_S && x.X_CS.isApprox(y.X_CS, 0.0);
                    });
}

bool are_same(const Surroundings& a, const Surroundings& b) {
  const auto plane = [](const Surroundings& s) {
    return s.support ? Eigen::Vector4d(s.support->n_C.x(), s.support->n_C.y(), s.support->n_C.z(),
                                       s.support->offset)
                     : Eigen::Vector4d(Eigen::Vector4d::Zero());
  };
  return are_same(a.robot, b.robot) && a.map.tree == b.map.tree &&
         a.map.X_CM.isApprox(b.map.X_CM, 0.0) && plane(a) == plane(b);
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
GraspPlan PairPlanner::plan_in_camera(const SharedPair& pair, const Known& known,
                                      const GraspQuery& query, bool advise) {
  const bool as_before = pair == ready_ && are_same(known.surroundings, of_scene_);
  if (as_before && !advise) return scene_->plan(query);
  const Things things = things_in_camera(*pair, settings_);
  PlanOptions options = settings_.plan;
  options.deadline_ms = *query.deadline_ms;
  // Whatever throws from here on leaves no scene that a later query could take for another one.
  ready_ = nullptr;
  of_scene_ = known.surroundings;
  Surroundings surroundings = known.surroundings;
  if (settings_.remembers() && pair->placement.X_WK) {
    surroundings.views = memory_.others(pair->cloud->utime, *pair->placement.X_WK);
    // The newest views come first.
    if (surroundings.views.size() > max_views_) surroundings.views.resize(max_views_);
  }
  scene_.emplace(things.cloud, things.detections, settings_.gripper, options, surroundings,
                 things.boxes, things.bodies);
  GraspPlan plan = scene_->plan_from_start(query);
  fit_views(surroundings.views.size(), plan);
  // A scene that was cut short may lack targets, so the next query for this cloud makes a new one.
  if (!plan.cut) ready_ = pair;
  if (advise) {
    plan.remedies = find_remedies(plan, things.cloud, things.detections, settings_.gripper, options,
                                  surroundings, query, things.boxes, things.bodies);
    plan.looks = propose_looks(plan, things.bodies, things.detections, settings_.gripper, options,
                               viewpoints_of(things.cloud, surroundings));
  }
  return plan;
}

/// Chooses how many views the next plan may have, so that there is time for grasps. Without a
/// deadline all views count, so that each replay gives the same plans.
/// @param views  number of views of a plan
void PairPlanner::fit_views(std::size_t views, const GraspPlan& plan) {
  // With a view more or less, plans take a share of the deadline between these.
  constexpr double kLong = 0.6, kShort = 0.3;
  const double deadline = settings_.plan.deadline_ms;
  if (deadline == 0.0) return;
  if (plan.cut) {
    max_views_ = views / 2;
  } else if (plan.total_ms > kLong * deadline && views > 0) {
    max_views_ = views - 1;
  } else if (plan.total_ms < kShort * deadline && max_views_ <= views) {
    max_views_ = views + 1;
  }
}

void PairPlanner::remember(const bus::CloudMessage& message, const Placement& placement,
                           const RobotShapes& robot, int camera) {
  if (!settings_.remembers() || !placement.X_WK) return;
  if (forgotten_.is_after(message.utime)) return;
  // What another camera shows may change the plans on a cloud that has been planned on.
  if (camera != 0) ready_ = nullptr;
  const Eigen::Isometry3d& X_WK = *placement.X_WK;
  const PointCloud cloud = in_camera_frame(message.cloud, placement, settings_.frames);
  const Eigen::Isometry3d correction =
      memory_.add(message.utime, robot.taken_from(cloud), X_WK, camera);
  views_ = static_cast<std::int64_t>(memory_.size());
  correction_ = (correction * X_WK.translation() - X_WK.translation()).norm();
}

void PairPlanner::forget(std::int64_t utime, const std::optional<ForgottenRegion>& region) {
  forgotten_.set(utime);
  if (region) {
    memory_.forget(region->X_WR, region->box_R);
  } else {
    memory_.forget();
    views_ = 0;
  }
  ready_ = nullptr;
}

GraspPlan PairPlanner::plan(const SharedPair& pair, const Known& known, const GraspQuery& query,
                            bool advise) {
  GraspQuery timed = with_conditions(query, settings_, known, pair->placement);
  timed.deadline_ms = query.deadline_ms.value_or(settings_.plan.deadline_ms);
  GraspPlan plan = plan_in_camera(pair, known, timed, advise);
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
      const bool said =
          std::find(plan.warnings.begin(), plan.warnings.end(), warning) != plan.warnings.end();
      if (!said) plan.warnings.push_back(warning);
    }
  }
  return moved(std::move(plan), placement.X_RK);
}

}  // namespace quadrille
