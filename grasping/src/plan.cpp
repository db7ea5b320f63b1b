#include "quadrille/grasping/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "body/pieces.hpp"
#include "quadrille/grasping/shape.hpp"
#include "space/support.hpp"
#include "target_planner.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A cap, a second fit or a fragment of the target: its middle lies in the body, and it is no
// larger.
bool part_of(const Detection& other, const Body& body) {
  const Eigen::Vector3d middle = other.X_CQ * Eigen::Vector3d(other.extent_Q.center());
  const double size = body.bounds_Q().sizes().maxCoeff();
  return body.contains(middle, 0.006) && other.extent_Q.sizes().maxCoeff() <= 1.3 * size + 0.01;
}

// Points of the target lie this far beside its fitted surface [m].
constexpr double kCarveNoise = 0.002;
// 30 MB and about 100 ms of mapping.
constexpr double kMaxVoxels = 3e7;
// Wide bodies are mapped only if their rim can be held. Across a slanted box, or a body whose size
// is poorly known, there may still be less than its smallest size.
constexpr double kWidthToOpening = 1.5;
// A rim farther than this from its own middle is no tableware [m].
constexpr double kWidestShell = 0.4;

bool graspable(const Body& body, const Gripper& gripper) {
  return body.bounds_Q().sizes().minCoeff() < gripper.max_opening * kWidthToOpening;
}

Eigen::AlignedBox3d around(const Body& body, double distance) {
  Eigen::AlignedBox3d box = body.bounds_C();
  box.min().array() -= distance;
  box.max().array() += distance;
  return box;
}

/// Composes the stages over one cloud.
class Planner {
 public:
  Planner(const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
          const PlanOptions& options, const std::vector<PointCloud>& further)
      : cloud_(cloud),
        detections_(detections),
        gripper_(gripper),
        options_(options),
        further_(further) {}

  GraspPlan plan() {
    const Clock::time_point start = Clock::now();
    stage("shapes", [&] { make_shapes(); });
    if (cloud_.points.empty()) warn("the cloud is empty");
    stage("view", [&] { view_.emplace(cloud_, options_.baseline, options_.resolution); });
    if (!view_->valid()) warn("no point lies before the viewpoint: all space counts as unknown");
    stage("targets", [&] { choose_targets(); });
    stage("occupancy", [&] { map_space(); });
    stage("grasps", [&] { plan_targets(); });
    select();
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
    for (std::size_t i = 0; i < detections_.size(); ++i) {
      const Detection& d = detections_[i];
      std::string why;
      const std::vector<CollisionShape> shapes = quadrille::make_shapes(d, &why);
      plan_.shapes.insert(plan_.shapes.end(), shapes.begin(), shapes.end());
      shape_of_.resize(plan_.shapes.size(), i);
      if (shapes.empty() || (d.type != QuadricType::kPlane && !make_body(d))) {
        ++plan_.rejected["no_shape"];
      }
      if (shapes.empty()) {
        warn("quadric " + std::to_string(d.id) + " has no collision shape: " + why);
      }
    }
  }

  void choose_targets() {
    for (const Detection& d : detections_) {
      if (d.type == QuadricType::kPlane) continue;
      const std::optional<Body> body = make_body(d);
      if (!body) continue;
      Target target{d.id, d.score, *body, supports_of(*body, detections_), {}, {}, true};
      const bool inside = seen_from_inside(d, *body);
      target.shell = shell_of(target, inside);
      if (target.shell) {
        const std::vector<ContactLine> lines = rim_lines(*target.shell, gripper_);
        target.rim = measured_lines(*target.shell, lines, cloud_);
        const int unmeasured = static_cast<int>(lines.size() - target.rim.size());
        if (unmeasured > 0) plan_.rejected["unmeasured"] += unmeasured;
      }
      // What was seen from inside is no solid: only its wall can be held.
      target.solid = !inside && graspable(*body, gripper_);
      if (target.solid || target.shell) {
        targets_.push_back(std::move(target));
      } else {
        ++plan_.rejected[inside ? "seen_from_inside" : "width"];
      }
    }
  }

  std::optional<Shell> shell_of(const Target& target, bool inside) const {
    if (target.body.bounds_Q().sizes().maxCoeff() > kWidestShell) return std::nullopt;
    const Eigen::Vector3d up_C =
        target.supports.empty() ? Eigen::Vector3d::Zero() : target.supports.front().n_C();
    return find_shell(target.body, inside, cloud_, *view_, up_C,
                      {options_.min_wall, options_.max_wall});
  }

  // How far the hand reaches from a target's surface.
  double reach() const {
    const double back = gripper_.finger.z() +
                        gripper_.max_extension(gripper_.min_opening, gripper_.max_opening) +
                        gripper_.palm.z() + options_.approach;
    return Eigen::Vector2d(back, 0.5 * gripper_.palm.head<2>().norm()).norm();
  }

  void map_space() {
    Eigen::AlignedBox3d region;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Target& target : targets_) {
      region.extend(around(target.body, reach()));
      boxes.push_back(around(target.body, reach() + kFarthestClearance));
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

  CollisionScene scene_of(const Target& target, const ObstacleMap& base) const {
    const Eigen::AlignedBox3d region = around(target.body, reach() + kFarthestClearance);
    CollisionScene scene{base.within(region), target.supports, {}, {}};
    for (std::size_t n = 0; n < plan_.shapes.size(); ++n) {
      const Detection& d = detections_[shape_of_[n]];
      if (d.id != target.id && !part_of(d, target.body) && may_reach(plan_.shapes[n], region)) {
        scene.neighbours.push_back(plan_.shapes[n]);
      }
    }
    return scene;
  }

  // The target's own voxels give way; those of what it stands on stay.
  CollisionScene solid_scene(const Target& target, const ObstacleMap& base) const {
    CollisionScene scene = scene_of(target, base);
    scene.target = make_pieces(target.body);
    scene.map.carve(target.body, carve_margin(),
                    [&](const Eigen::Vector3d& p_C) { return holds_up(target, p_C); });
    clear_shadow(target.body, scene);
    return scene;
  }

  // The same for the wall alone: what the vessel holds, and its hidden bottom, stay in the way.
  CollisionScene shell_scene(const Target& target, const ObstacleMap& base) const {
    CollisionScene scene = scene_of(target, base);
    const Shell& shell = *target.shell;
    scene.target = make_wall(shell);
    scene.end_doubt = scene.margin;  // find_shell() put the rim where the points end
    const double margin = carve_margin();
    scene.map.carve(shell.body, margin + shell.outer(), [&](const Eigen::Vector3d& p_C) {
      return !shell.in_wall(p_C, margin) || holds_up(target, p_C);
    });
    clear_shadow(shell.body, scene);
    return scene;
  }

  // A voxel that reaches into the target has its centre within half its diagonal, plus the noise of
  // its points.
  double carve_margin() const {
    return 0.5 * std::sqrt(3.0) * plan_.space->resolution() + kCarveNoise;
  }

  bool holds_up(const Target& target, const Eigen::Vector3d& p_C) const {
    const auto near = [&](const SupportPlane& plane) {
      return plane.distance(p_C) < 0.5 * plan_.space->resolution();
    };
    return std::any_of(target.supports.begin(), target.supports.end(), near);
  }

  void clear_shadow(const Body& body, CollisionScene& scene) const {
    if (options_.unknown != UnknownPolicy::kTargetShadow) return;
    scene.map.clear_shadow(*plan_.space, *view_, body, around(body, reach()));
  }

  void plan_targets() {
    if (targets_.empty()) return;
    ObstacleMap base(*plan_.space, options_.unknown != UnknownPolicy::kFree);
    if (view_->valid()) base.refine(*view_, further_.empty());
    const auto keep = [&](const std::vector<Grasp>& grasps) {
      plan_.grasps.insert(plan_.grasps.end(), grasps.begin(), grasps.end());
      return !grasps.empty();
    };
    for (const Target& target : targets_) {
      bool held = false;
      std::optional<CollisionScene> solid;
      if (target.solid) {
        solid = solid_scene(target, base);
        held |= keep(TargetPlanner(target, gripper_, options_, *plan_.space, *solid)
                         .plan(cloud_.viewpoint, plan_.rejected));
      }
      if (target.shell) {
        const CollisionScene scene = shell_scene(target, base);
        held |= keep(TargetPlanner(target, gripper_, options_, *plan_.space, scene)
                         .plan_rim(cloud_.viewpoint, plan_.rejected));
      }
      if (solid && !held) {
        keep(TargetPlanner(target, gripper_, options_, *plan_.space, *solid)
                 .plan_tips(cloud_.viewpoint, plan_.rejected));
      }
    }
  }

  // Best first; the best grasp of each target before any second one is dropped.
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
  GraspPlan plan_;
  std::vector<Target> targets_;
  std::vector<std::size_t> shape_of_;
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
