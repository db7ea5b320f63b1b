#include "quadrille/grasping/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "target_planner.hpp"

namespace quadrille {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Shorter planes are but neighbours: boxes, books, lids [m].
constexpr double kLeastSupport = 0.15;
// So many times the body's size: what is not wider than the body is a part of it.
constexpr double kSupportToBody = 1.5;
// The body itself and its shadow cut off what is seen of the plane below it, and the plane goes on
// beyond the image [m].
constexpr double kSupportGoesOn = 0.1;

// A large plane that the target stands on: below the body's middle, no farther from the body than
// the body is large (what stands before it may hide the body's foot).
std::optional<SupportPlane> support(const Detection& plane, const Body& body) {
  const double size = body.bounds_Q().sizes().maxCoeff();
  const double least = std::max(kLeastSupport, kSupportToBody * size);
  if (plane.extent_Q.sizes().head<2>().minCoeff() < least) return std::nullopt;
  const Eigen::Vector2d beyond = Eigen::Vector2d::Constant(kSupportGoesOn);
  const SupportPlane found{
      plane.X_CQ,
      {plane.extent_Q.min().head<2>() - beyond, plane.extent_Q.max().head<2>() + beyond}};
  const Eigen::Vector3d middle_P = plane.X_CQ.inverse() * body.centre_C();
  if (!found.extent_P.contains(middle_P.head<2>()) || middle_P.z() <= 0.0) return std::nullopt;
  const Eigen::Vector3d n_Q = body.X_CQ.linear().transpose() * found.n_C();
  const double foot = middle_P.z() - n_Q.cwiseAbs().dot(0.5 * body.bounds_Q().sizes());
  if (foot > size) return std::nullopt;
  return found;
}

// A cap, a second fit or a fragment of the target: its middle lies in the body, and it is no
// larger.
bool part_of(const Detection& other, const Body& body) {
  const Eigen::Vector3d middle = other.X_CQ * Eigen::Vector3d(other.extent_Q.center());
  const double size = body.bounds_Q().sizes().maxCoeff();
  return body.contains(middle, 0.006) && other.extent_Q.sizes().maxCoeff() <= 1.3 * size + 0.01;
}

bool graspable(const Body& body, const Gripper& gripper) {
  return body.bounds_Q().sizes().minCoeff() < gripper.max_opening * 1.5;
}

/// Composes the stages over one cloud.
class Planner {
 public:
  Planner(const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
          const PlanOptions& options)
      : cloud_(cloud), detections_(detections), gripper_(gripper), options_(options) {}

  GraspPlan plan() {
    const Clock::time_point start = Clock::now();
    stage("shapes", [&] { make_shapes(); });
    if (cloud_.points.empty()) warn("the cloud is empty");
    stage("view", [&] { view_.emplace(cloud_, options_.baseline); });
    if (!view_->valid()) warn("no point lies before the viewpoint: all space counts as unknown");
    stage("occupancy", [&] { map_space(); });
    stage("octree", [&] { plan_.occupancy = grid_->to_octree(); });
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
      if (std::optional<CollisionShape> shape = make_shape(d, &why)) {
        plan_.shapes.push_back(*shape);
        shape_of_.push_back(i);
      } else {
        ++plan_.rejected["no_shape"];
      }
      if (is_flat(d.type) && d.type != QuadricType::kParallelPlanes) continue;
      const std::optional<Body> body = make_body(d);
      if (!body) continue;
      if (graspable(*body, gripper_)) {
        targets_.push_back({d.id, d.score, *body});
      } else {
        ++plan_.rejected["width"];
      }
    }
  }

  // How far the hand reaches from a target's surface.
  double reach() const {
    const double back = gripper_.finger.z() + gripper_.palm.z() + options_.approach;
    return Eigen::Vector2d(back, 0.5 * gripper_.palm.head<2>().norm()).norm();
  }

  void map_space() {
    Eigen::AlignedBox3d region;
    for (const Target& target : targets_) {
      Eigen::AlignedBox3d box = target.body.bounds_C();
      box.min().array() -= reach();
      box.max().array() += reach();
      region.extend(box);
    }
    constexpr double kMostVoxels = 3e7;
    double resolution = options_.resolution;
    if (!region.isEmpty()) {
      const double voxels = region.volume() / std::pow(resolution, 3);
      if (voxels > kMostVoxels) {
        resolution *= std::cbrt(voxels / kMostVoxels);
        warn("the targets lie far apart: occupancy is mapped at a coarser resolution");
      }
    }
    grid_.emplace(cloud_, *view_, region, resolution);
  }

  CollisionScene scene_of(const Target& target, const ObstacleMap& base) const {
    CollisionScene scene{base, {}, {}, make_pieces(target.body)};
    for (const Detection& d : detections_) {
      if (d.type != QuadricType::kPlane) continue;
      if (const auto plane = support(d, target.body)) scene.planes.push_back(*plane);
    }
    // The one nearest to the target's middle is the one it stands on.
    const Eigen::Vector3d middle = target.body.centre_C();
    std::stable_sort(scene.planes.begin(), scene.planes.end(), [&](const auto& a, const auto& b) {
      return a.distance(middle) < b.distance(middle);
    });
    for (std::size_t n = 0; n < plan_.shapes.size(); ++n) {
      const Detection& d = detections_[shape_of_[n]];
      if (d.id != target.id && !part_of(d, target.body))
        scene.neighbours.push_back(plan_.shapes[n]);
    }
    carve(target, scene);
    return scene;
  }

  // The target's own voxels give way; those of what it stands on stay.
  void carve(const Target& target, CollisionScene& scene) const {
    const double resolution = grid_->resolution();
    const double margin = 0.87 * resolution + 0.002;
    scene.map.carve(target.body, margin, [&](const Eigen::Vector3d& centre) {
      return std::any_of(scene.planes.begin(), scene.planes.end(), [&](const SupportPlane& plane) {
        return plane.distance(centre) < 0.5 * resolution;
      });
    });
    if (options_.unknown != UnknownPolicy::kTargetShadow) return;
    Eigen::AlignedBox3d region = target.body.bounds_C();
    region.min().array() -= reach();
    region.max().array() += reach();
    scene.map.clear_shadow(*grid_, *view_, target.body, region);
  }

  void plan_targets() {
    if (targets_.empty()) return;
    const ObstacleMap base(*grid_, options_.unknown != UnknownPolicy::kFree);
    for (const Target& target : targets_) {
      const CollisionScene scene = scene_of(target, base);
      TargetPlanner planner(target, gripper_, options_, *grid_, scene);
      const std::vector<Grasp> grasps = planner.plan(cloud_.viewpoint, plan_.rejected);
      plan_.grasps.insert(plan_.grasps.end(), grasps.begin(), grasps.end());
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
  GraspPlan plan_;
  std::vector<Target> targets_;
  std::vector<std::size_t> shape_of_;
  std::optional<DepthView> view_;
  std::optional<OccupancyGrid> grid_;
};

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("plan options: ") + what);
}

}  // namespace

void PlanOptions::check() const {
  demand(resolution >= 0.0005 && resolution <= 0.1, "resolution must lie in 0.0005 to 0.1 m");
  demand(friction > 0.0 && friction <= 10.0, "friction must lie in 0 to 10, above 0");
  demand(approach >= 0.0 && approach <= 1.0, "approach must lie in 0 to 1 m");
  demand(pad_margin >= 0.0 && pad_margin <= 0.1, "pad_margin must lie in 0 to 0.1 m");
  demand(baseline >= 0.0 && baseline <= 1.0, "baseline must lie in 0 to 1 m");
  demand(max_grasps >= 0, "max_grasps must not be negative");
}

GraspPlan plan_grasps(const PointCloud& cloud, const std::vector<Detection>& detections,
                      const Gripper& gripper, const PlanOptions& options) {
  gripper.check();
  options.check();
  return Planner(cloud, detections, gripper, options).plan();
}

}  // namespace quadrille
