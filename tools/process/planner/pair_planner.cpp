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

/// What was found in a cloud, in the camera's frame K.
struct Things {
  std::vector<Detection> detections;
  std::optional<std::vector<Box>> boxes;
  std::vector<SceneBody> bodies;
};

Things things_in_camera(const CloudAndQuadrics& pair) {
  const Placement& placement = pair.placement;
  const bool as_results = pair.quadrics.frame == placement.frame;
  const Eigen::Isometry3d X_KF = (as_results ? placement.X_RK : placement.X_CK).inverse();
  Things things{moved(pair.quadrics.detections, X_KF), pair.others.boxes,
                moved(pair.others.bodies, X_KF)};
  if (things.boxes) things.boxes = moved(*std::move(things.boxes), X_KF);
  return things;
}

/// Returns a cloud in the camera's frame, without a viewpoint if the camera's pose is not known.
SeenCloud see(const bus::CloudMessage& message, const Placement& placement,
              const PlannerSettings& settings) {
  PointCloud cloud = in_camera_frame(message.cloud, placement, settings.frames);
  if (!placement.lack.empty()) {
    cloud.viewpoint.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return {std::move(cloud), settings.plan};
}

// Clouds that are prepared at most while no quadrics come: that on which the detector works, and
// the next one. Each takes some 15 MB.
constexpr std::size_t kMaxPrepared = 2;

}  // namespace

void PairPlanner::prepare(const SharedCloud& cloud, const Placement& placement) {
  if (prepared_.size() >= kMaxPrepared) return;
  SeenCloud seen = see(*cloud, placement, settings_);
  std::optional<PreparedView> view;
  if (may_remember(cloud->utime, placement)) view = memory_.prepare(seen.cloud());
  prepared_.push_back({cloud, std::move(seen), std::move(view)});
}

/// Returns the cloud of a pair as it was prepared, if it was, and forgets those that were prepared
/// before it, whose quadrics will not come.
SeenCloud PairPlanner::take_seen(const CloudAndQuadrics& pair) {
  const auto found = std::find_if(prepared_.begin(), prepared_.end(),
                                  [&](const Prepared& one) { return one.cloud == pair.cloud; });
  if (found == prepared_.end()) {
    // Clouds that wait may be older than this one.
    prepared_.clear();
    return see(*pair.cloud, pair.placement, settings_);
  }
  SeenCloud seen = std::move(found->seen);
  prepared_.erase(prepared_.begin(), found + 1);
  return seen;
}

/// Plans on a pair in the camera's frame. The scene is made unless it is that of the last call.
GraspPlan PairPlanner::plan_in_camera(const SharedPair& pair, const Known& known,
                                      const GraspQuery& query, bool advise) {
  const bool as_before = pair == ready_ && are_same(known.surroundings, of_scene_);
  if (as_before && !advise) return scene_->plan(query);
  const Things things = things_in_camera(*pair);
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
  SeenCloud seen = take_seen(*pair);
  const PointCloud cloud = advise ? seen.cloud() : PointCloud();
  scene_.emplace(std::move(seen), things.detections, settings_.gripper, options, surroundings,
                 things.boxes, things.bodies);
  GraspPlan plan = scene_->plan_from_start(query);
  fit_views(surroundings.views.size(), plan);
  // A scene that was cut short may lack targets, so the next query for this cloud makes a new one.
  if (!plan.cut) ready_ = pair;
  if (advise) {
    plan.remedies = find_remedies(plan, cloud, things.detections, settings_.gripper, options,
                                  surroundings, query, things.boxes, things.bodies);
    plan.looks = propose_looks(plan, things.bodies, things.detections, settings_.gripper, options,
                               viewpoints_of(cloud, surroundings));
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

bool PairPlanner::may_remember(std::int64_t utime, const Placement& placement) const {
  return settings_.remembers() && placement.X_WK && !forgotten_.is_after(utime);
}

void PairPlanner::count_views(const Eigen::Isometry3d& correction, const Eigen::Isometry3d& X_WK) {
  views_ = static_cast<std::int64_t>(memory_.size());
  correction_ = (correction * X_WK.translation() - X_WK.translation()).norm();
}

void PairPlanner::remember(const CloudAndQuadrics& pair, const Known& known) {
  const RobotShapes& robot = known.surroundings.robot;
  const auto found = std::find_if(prepared_.begin(), prepared_.end(), [&](const Prepared& one) {
    return one.cloud == pair.cloud && one.view && robot.shapes.empty();
  });
  if (found == prepared_.end()) return remember(*pair.cloud, pair.placement, robot, 0);
  std::optional<PreparedView> view = std::exchange(found->view, std::nullopt);
  if (!may_remember(pair.cloud->utime, pair.placement)) return;
  const Eigen::Isometry3d& X_WK = *pair.placement.X_WK;
  count_views(memory_.add(pair.cloud->utime, *std::move(view), X_WK), X_WK);
}

void PairPlanner::remember(const bus::CloudMessage& message, const Placement& placement,
                           const RobotShapes& robot, int camera) {
  if (!may_remember(message.utime, placement)) return;
  // What another camera shows may change the plans on a cloud that has been planned on.
  if (camera != 0) ready_ = nullptr;
  const Eigen::Isometry3d& X_WK = *placement.X_WK;
  const PointCloud cloud = in_camera_frame(message.cloud, placement, settings_.frames);
  count_views(memory_.add(message.utime, robot.taken_from(cloud), X_WK, camera), X_WK);
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
