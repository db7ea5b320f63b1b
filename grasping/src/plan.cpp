#include "quadrille/grasping/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "body/body.hpp"
#include "quadrille/detector/find_boxes.hpp"
#include "quadrille/detector/viewpoint_check.hpp"
#include "quadrille/grasping/shape.hpp"
#include "targets/target.hpp"
#include "targets/target_grasps.hpp"
#include "targets/target_scene.hpp"
#include "view/depth_view.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// 30 MB and about 100 ms of mapping.
constexpr double kMaxVoxels = 3e7;

/// Composes the stages over one cloud.
class Planner {
 public:
  Planner(const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
          const PlanOptions& options, const std::vector<PointCloud>& further)
      : cloud_(cloud),
        detections_(detections),
        gripper_(gripper),
        options_(options),
        further_(further),
        reach_(hand_reach(gripper, options.approach)) {}

  GraspPlan plan() {
    const Clock::time_point start = Clock::now();
    stage("boxes", [&] { plan_.boxes = find_boxes(cloud_, detections_); });
    stage("shapes", [&] { make_shapes(); });
    if (cloud_.points.empty()) warn("the cloud is empty");
    stage("view", [&] { view_.emplace(cloud_, options_.baseline, options_.resolution); });
    const bool seen_so = has_viewpoint();
    if (seen_so && !view_->valid()) {
      warn("no point lies before the viewpoint: all space counts as unknown");
    }
    if (seen_so) stage("targets", [&] { choose_targets(); });
    stage("occupancy", [&] { map_space(); });
    if (seen_so) stage("grasps", [&] { plan_targets(); });
    select();
    for (const auto& [why, count] : refusals_) {
      if (count > 0) plan_.rejected.emplace(to_string(why), count);
    }
    plan_.total_ms = ms_since(start);
    return std::move(plan_);
  }

 private:
  template <class Work>
  void stage(const char* name, Work&& work) {
    const Clock::time_point start = Clock::now();
    work();
    plan_.timings.push_back({name, ms_since(start)});
  }

  void warn(const std::string& text) { plan_.warnings.push_back(text); }

  void make_shapes() {
    for (const Box& box : plan_.boxes) {
      plan_.shapes.push_back(make_shape(box));
      owners_.push_back(owner_of(box));
    }
    for (const Detection& d : detections_) {
      // A box stands for its faces.
      if (is_face_of_box(d.id)) continue;
      std::string why;
      const std::vector<CollisionShape> shapes = quadrille::make_shapes(d, &why);
      plan_.shapes.insert(plan_.shapes.end(), shapes.begin(), shapes.end());
      owners_.resize(plan_.shapes.size(), owner_of(d));
      if (!is_wanted(d, options_)) continue;
      if (shapes.empty() || (d.type != QuadricType::kPlane && !make_body(d))) {
        ++refusals_[Refusal::kNoShape];
      }
      if (shapes.empty()) {
        warn("quadric " + std::to_string(d.id) + " has no collision shape: " + why);
      }
    }
  }

  /// False, and says why, if the cloud or another view cannot have been seen from its viewpoint:
  /// what counts as free would not be.
  bool has_viewpoint() {
    std::vector<std::string> doubts = {contradict_viewpoint(cloud_, detections_)};
    for (const PointCloud& cloud : further_) {
      doubts.push_back(contradict_viewpoint(cloud, detections_));
    }
    std::erase(doubts, "");
    for (const std::string& doubt : doubts) warn(doubt);
    if (doubts.empty()) return true;
    for (const Detection& d : detections_) {
      if (d.type != QuadricType::kPlane && is_wanted(d, options_)) ++refusals_[Refusal::kViewpoint];
    }
    return false;
  }

  void choose_targets() {
    ChosenTargets chosen =
        quadrille::choose_targets(cloud_, detections_, *view_, gripper_, options_);
    targets_ = std::move(chosen.targets);
    count(chosen.refusals);
    ChosenTargets boxes = choose_boxes(plan_.boxes, detections_, gripper_, options_);
    std::move(boxes.targets.begin(), boxes.targets.end(), std::back_inserter(targets_));
    count(boxes.refusals);
  }

  bool is_face_of_box(int id) const {
    return std::any_of(plan_.boxes.begin(), plan_.boxes.end(), [&](const Box& box) {
      return std::find(box.faces.begin(), box.faces.end(), id) != box.faces.end();
    });
  }

  void count(const RefusalCounts& refusals) {
    for (const auto& [why, number] : refusals) refusals_[why] += number;
  }

  void map_space() {
    Eigen::AlignedBox3d region;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Target& target : targets_) {
      region.extend(around(target.body, reach_));
      boxes.push_back(around(target.body, reach_ + kMaxClearance));
    }
    double resolution = options_.resolution;
    if (!region.isEmpty()) {
      const double voxels = region.volume() / std::pow(resolution, 3);
      if (voxels > kMaxVoxels) {
        resolution *= std::cbrt(voxels / kMaxVoxels);
        warn("the targets lie far apart: occupancy is mapped at a coarser resolution");
      }
    }
    const auto space = std::make_shared<OccupancyGrid>(region, resolution);
    space->restrict_to(std::move(boxes));
    space->add(cloud_, *view_);
    for (const PointCloud& cloud : further_) {
      space->add(cloud, DepthView(cloud, options_.baseline, options_.resolution));
    }
    const auto standing = std::find_if(targets_.begin(), targets_.end(), [](const Target& target) {
      return !target.supports.empty();
    });
    if (options_.clear_above && view_->valid() && standing != targets_.end()) {
      space->clear_above(*view_, standing->supports.front().n_C());
    }
    plan_.space = space;
  }

  void plan_targets() {
    if (targets_.empty()) return;
    ObstacleMap map(*plan_.space, options_.unknown != UnknownPolicy::kFree);
    if (view_->valid()) map.refine(*view_, further_.empty());
    const Surroundings around_them{*plan_.space, *view_,           map,   plan_.shapes,
                                   owners_,      options_.unknown, reach_};
    for (const Target& target : targets_) {
      if (target.wanted) plan_target(target, around_them);
    }
  }

  /// By the tips only what is held in no other way.
  void plan_target(const Target& target, const Surroundings& around_it) {
    const auto task = [&](const CollisionScene& scene) {
      return TargetTask{target, gripper_, options_, *plan_.space, scene, cloud_.viewpoint};
    };
    bool held = false;
    std::optional<CollisionScene> solid;
    if (target.solid) {
      solid = solid_scene(target, around_it);
      held |= keep(grasps_across(task(*solid)));
    }
    if (target.shell) {
      const CollisionScene shell = shell_scene(target, around_it);
      held |= keep(grasps_at_rim(task(shell)));
    }
    if (solid && !held) keep(grasps_by_tips(task(*solid)));
  }

  /// True if there are any.
  bool keep(const TargetGrasps& found) {
    plan_.grasps.insert(plan_.grasps.end(), found.grasps.begin(), found.grasps.end());
    count(found.refusals);
    return !found.grasps.empty();
  }

  /// Best first; the best grasp of each target before any second one is dropped.
  void select() {
    const auto better = [](const Grasp& a, const Grasp& b) { return a.score > b.score; };
    std::vector<Grasp>& grasps = plan_.grasps;
    std::stable_sort(grasps.begin(), grasps.end(), better);
    if (grasps.size() <= static_cast<std::size_t>(options_.max_grasps)) return;
    std::map<int, bool> seen;
    std::stable_partition(grasps.begin(), grasps.end(), [&](const Grasp& grasp) {
      return !std::exchange(seen[grasp.target], true);
    });
    grasps.resize(options_.max_grasps);
    std::stable_sort(grasps.begin(), grasps.end(), better);
  }

  const PointCloud& cloud_;
  const std::vector<Detection>& detections_;
  const Gripper& gripper_;
  const PlanOptions& options_;
  const std::vector<PointCloud>& further_;
  // How far the hand reaches from a target's surface [m].
  const double reach_;
  GraspPlan plan_;
  RefusalCounts refusals_;
  std::vector<Target> targets_;
  // For each shape.
  std::vector<ShapeOwner> owners_;
  std::optional<DepthView> view_;
};

}  // namespace

GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options,
                      const std::vector<PointCloud>& further) {
  gripper.check();
  options.check();
  return Planner(cloud, detections, gripper, options, further).plan();
}

}  // namespace quadrille
