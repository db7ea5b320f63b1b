#include "scene/make_scene_parts.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iterator>
#include <numeric>
#include <sstream>
#include <utility>

#include "body/body.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/grasping/shape.hpp"
#include "scene/view_clouds.hpp"
#include "space/map_limits.hpp"
#include "space/space_mapper.hpp"
#include "space/support.hpp"
#include "space/surface_cover.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

ShapeOwner owner_of(const Detection& detection) {
  return {detection.id, detection.X_CQ * Eigen::Vector3d(detection.extent_Q.center()),
          detection.extent_Q.sizes().maxCoeff()};
}

ShapeOwner owner_of(const Box& box) {
  return {box.id, box.X_CB.translation(), box.size.maxCoeff()};
}

/// Boxes may come from messages, so their fields are checked.
bool is_sound(const Box& box) {
  const bool sized = box.size.allFinite() && box.size.minCoeff() > 0.0 && !box.inner_B.isEmpty() &&
                     !box.outer_B.isEmpty();
  return sized && box.X_CB.matrix().allFinite() && box.X_CB.linear().isUnitary(1e-3);
}

/// Makes the parts of a scene, stage by stage.
class SceneMaker {
 public:
  SceneMaker(const PointCloud& cloud, const std::vector<Detection>& detections,
             const Surroundings& known, double deadline_ms, SceneParts& parts)
      : detections_(detections),
        known_(known),
        deadline_(deadline_ms),
        half_(0.5 * deadline_ms),
        parts_(parts),
        views_(cloud, known, detections, &parts.warnings) {}

  void make(std::optional<std::vector<Box>> boxes, const std::vector<SceneBody>& bodies) {
    drop_surplus();
    stage("boxes", [&] {
      parts_.boxes = boxes ? std::move(*boxes) : find_boxes(views_.first(), detections_);
      std::erase_if(parts_.boxes, [](const Box& box) { return !is_sound(box); });
    });
    stage("shapes", [&] { make_shapes(); });
    if (views_.first().points.empty()) warn("the cloud is empty");
    check_support();
    const PlanOptions& options = parts_.options;
    stage("view", [&] {
      std::vector<DepthView> views;
      views.reserve(views_.size());
      for (const ViewClouds::View& view : views_) {
        views.emplace_back(*view.seen, options.baseline, options.resolution);
      }
      parts_.shared_views = std::make_shared<const std::vector<DepthView>>(std::move(views));
      parts_.views = *parts_.shared_views;
    });
    const bool seen_so = has_viewpoint();
    if (seen_so && !sighted()) {
      warn("no point lies before the viewpoint: all space counts as unknown");
    } else if (seen_so && !parts_.views.front().valid()) {
      warn("the cloud shows nothing: the plan is on what the further views show");
    }
    if (seen_so) stage("targets", [&] { choose_targets(bodies); });
    if (deadline_.passed()) {
      drop_all_targets();
    } else {
      stage("occupancy", [&] { map_space(); });
    }
  }

 private:
  template <class Work>
  void stage(const char* name, Work&& work) {
    const Clock::time_point start = Clock::now();
    work();
    const std::chrono::duration<double, std::milli> passed = Clock::now() - start;
    parts_.timings.push_back({name, passed.count()});
  }

  void warn(const std::string& text) { parts_.warnings.push_back(text); }

  /// Keeps the detections with the best scores, in their original order.
  void drop_surplus() {
    const std::size_t all = detections_.size();
    const auto most = static_cast<std::size_t>(parts_.options.max_detections);
    if (all <= most) return;
    std::vector<std::size_t> order(all);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return detections_[a].score > detections_[b].score;
    });
    const auto surplus = order.begin() + static_cast<std::ptrdiff_t>(most);
    for (auto index = surplus; index != order.end(); ++index) {
      const Detection& d = detections_[*index];
      refuse(d.id, Refusal::kSurplus, is_wanted(d, parts_.options));
    }
    std::sort(order.begin(), surplus);
    std::vector<Detection> kept;
    for (auto index = order.begin(); index != surplus; ++index) kept.push_back(detections_[*index]);
    detections_ = std::move(kept);
    warn("of " + std::to_string(all) + " detections only the " + std::to_string(most) +
         " with the best score are planned on (planner.max_detections)");
  }

  void make_shapes() {
    for (const Box& box : parts_.boxes) {
      parts_.shapes.push_back(make_shape(box));
      parts_.owners.push_back(owner_of(box));
    }
    for (const Detection& d : detections_) {
      if (d.type == QuadricType::kPlane) parts_.why_none[d.id] = "is a plane";
      // A box takes the place of its faces.
      if (const Box* box = box_of(d.id)) {
        parts_.why_none[d.id] = "is a face of box " + std::to_string(box->id);
        continue;
      }
      const std::vector<CollisionShape> shapes = quadrille::make_shapes(d);
      parts_.shapes.insert(parts_.shapes.end(), shapes.begin(), shapes.end());
      parts_.owners.resize(parts_.shapes.size(), owner_of(d));
      if (!is_wanted(d, parts_.options)) {
        parts_.why_none[d.id] = "is of a type that is not to be grasped";
        continue;
      }
      if (shapes.empty() || (d.type != QuadricType::kPlane && !make_body(d))) {
        refuse(d.id, Refusal::kNoShape);
      }
      if (shapes.empty()) {
        warn("quadric " + std::to_string(d.id) + " has no collision shape: " +
             std::string(to_string(d.type)) + " has no finite, positive size");
      }
    }
  }

  /// Warns if the sensor looks from below the plane on which things are said to stand.
  void check_support() {
    if (!known_.support) return;
    const double height =
        known_.support->n_C.dot(views_.first().viewpoint) - known_.support->offset;
    if (height < 0.0) warn("the viewpoint lies below the support; does its normal point upwards?");
  }

  /// Returns false, and says why, if the cloud cannot have been seen from its viewpoint, because
  /// its free space would then be wrong.
  bool has_viewpoint() {
    const std::string doubt = contradict_viewpoint(views_.first(), detections_);
    if (doubt.empty()) return true;
    warn(doubt);
    for (const Detection& d : detections_) {
      if (d.type == QuadricType::kPlane || !is_wanted(d, parts_.options)) continue;
      refuse(d.id, Refusal::kViewpoint);
    }
    return false;
  }

  /// True if a view has points before its viewpoint.
  bool sighted() const {
    return std::any_of(parts_.views.begin(), parts_.views.end(),
                       [](const DepthView& view) { return view.valid(); });
  }

  void choose_targets(const std::vector<SceneBody>& bodies) {
    const CloudRuns cloud(views_.all());
    add(quadrille::choose_targets(cloud, detections_, parts_.views, parts_.gripper, parts_.options,
                                  half_));
    add(choose_boxes(cloud, parts_.boxes, detections_, parts_.gripper, parts_.options, half_));
    std::vector<Target> unshaped =
        choose_unshaped(bodies, parts_.targets, detections_, parts_.options);
    std::move(unshaped.begin(), unshaped.end(), std::back_inserter(parts_.targets));
    for (Target& target : parts_.targets) {
      target.view = best_view(target, cloud);
      if (!known_.support) continue;
      target.supports.push_back(plane_of(*known_.support, target.body.centre_C()));
    }
    drop_far_targets();
  }

  /// Drops all targets, since mapping the space around them takes long and is of no use if there is
  /// no time left to try them.
  void drop_all_targets() {
    for (const Target& target : parts_.targets) {
      refuse(target.id, Refusal::kDeadline, target.wanted);
    }
    parts_.targets.clear();
    warn("the deadline passed before space was mapped: the plan has no map");
  }

  /// Refuses targets that do not fit into one map, so that a body far away does not spoil the map
  /// for the others.
  void drop_far_targets() {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Target& target : parts_.targets) boxes.push_back(around(target.body, parts_.reach));
    const std::vector<std::size_t> far =
        find_far_boxes(boxes, views_.first().viewpoint, parts_.options.resolution);
    for (auto n = far.rbegin(); n != far.rend(); ++n) {
      const auto target = parts_.targets.begin() + static_cast<std::ptrdiff_t>(*n);
      refuse(target->id, Refusal::kFar, target->wanted);
      parts_.targets.erase(target);
    }
    if (far.empty()) return;
    warn(
        "targets that are too large, or too far from the viewpoint, to be mapped with the "
        "others: " +
        std::to_string(far.size()));
  }

  void add(ChosenTargets chosen) {
    std::move(chosen.targets.begin(), chosen.targets.end(), std::back_inserter(parts_.targets));
    for (const auto& [id, why] : chosen.refused) refuse(id, why);
    parts_.refusals[Refusal::kUnmeasured] += chosen.unmeasured;
  }

  /// Refuses a detection or box as a target; only if it is wanted, this counts.
  void refuse(int id, Refusal why, bool wanted = true) {
    parts_.why_none[id] = "cannot be held: " + std::string(to_string(why));
    if (!wanted) return;
    ++parts_.refusals[why];
    parts_.refused.emplace(id, why);
  }

  /// The box of which a detection is a face; nullptr if there is none.
  const Box* box_of(int id) const {
    const auto found = std::find_if(parts_.boxes.begin(), parts_.boxes.end(), [&](const Box& box) {
      return std::find(box.faces.begin(), box.faces.end(), id) != box.faces.end();
    });
    return found == parts_.boxes.end() ? nullptr : &*found;
  }

  void map_space() {
    Eigen::AlignedBox3d region;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Target& target : parts_.targets) {
      region.extend(around(target.body, parts_.reach));
      boxes.push_back(around(target.body, parts_.reach + kMaxClearance));
    }
    double resolution = parts_.options.resolution;
    if (!region.isEmpty()) resolution = fit_resolution(region, resolution);
    if (resolution > parts_.options.resolution) {
      std::ostringstream text;
      text << std::setprecision(3) << "the targets lie far apart: occupancy is mapped at "
           << 1000.0 * resolution << " mm in place of " << 1000.0 * parts_.options.resolution
           << " mm; crop the cloud for a finer map";
      warn(text.str());
    }
    SpaceMapper mapper(region, resolution, std::move(boxes), parts_.options.threads);
    // A single view has nothing to repeat.
    SurfaceCover cover(parts_.views.size() > 1 ? region : Eigen::AlignedBox3d(), resolution);
    for (std::size_t v = 0; v < parts_.views.size(); ++v) {
      const std::vector<std::uint8_t> left_out = without_repeats(v, cover);
      mapper.add_points(*views_[v].things, left_out);
      keep_points(v, region, left_out);
      if (v + 1 < parts_.views.size()) cover.add(views_[v].things->points, left_out);
    }
    parts_.points.runs = CloudRuns(parts_.points.p_C);
    const bool occupied_by_map = known_.map.tree && mapper.add(known_.map);
    for (const SolidShape& shape : known_.robot.shapes) {
      mapper.free_within(NearShape(shape, known_.robot.padding));
    }
    parts_.space = std::make_shared<OccupancyGrid>(
        std::move(mapper).take_on_demand(parts_.shared_views, up_to_clear()));
    if (parts_.targets.empty()) return;
    const UnknownPolicy unknown = parts_.options.unknown;
    parts_.map.emplace(
        *parts_.space,
        unknown == UnknownPolicy::kObstacle || unknown == UnknownPolicy::kTargetShadow,
        parts_.views, !occupied_by_map);
  }

  /// Marks the strays of a view, and the points that show what views before it show.
  std::vector<std::uint8_t> without_repeats(std::size_t view, const SurfaceCover& before) const {
    std::vector<std::uint8_t> left_out = parts_.views[view].stray();
    if (view == 0) return left_out;
    const std::vector<Eigen::Vector3f>& points = views_[view].things->points;
    for (std::size_t n = 0; n < points.size(); ++n) left_out[n] |= before.covers(points[n]);
    return left_out;
  }

  void keep_points(std::size_t view, const Eigen::AlignedBox3d& region,
                   const std::vector<std::uint8_t>& left_out) {
    const std::vector<Eigen::Vector3f>& points = views_[view].things->points;
    const Eigen::AlignedBox3f near = region.cast<float>();
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (near.contains(points.data()[n]) && !left_out.data()[n]) {
        parts_.points.p_C.push_back(points.data()[n]);
      }
    }
    parts_.points.view.resize(parts_.points.p_C.size(), static_cast<int>(view));
  }

  /// The view with the most points in the box around a target.
  /// @param cloud  the points of all views, one view after the other
  std::size_t best_view(const Target& target, const CloudRuns& cloud) const {
    if (views_.size() == 1) return 0;
    std::vector<std::size_t> counts(views_.size(), 0), ends;
    for (const ViewClouds::View& view : views_) {
      ends.push_back((ends.empty() ? 0 : ends.back()) + view.things->points.size());
    }
    std::size_t view = 0;
    cloud.each_in(target.body.bounds_C().cast<float>(), [&](std::size_t n) {
      while (n >= ends[view]) ++view;
      ++counts[view];
    });
    return static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                    counts.begin());
  }

  /// Returns the normal of the first support; zero if no space is to be cleared above it.
  Eigen::Vector3d up_to_clear() const {
    const auto standing =
        std::find_if(parts_.targets.begin(), parts_.targets.end(),
                     [](const Target& target) { return !target.supports.empty(); });
    const bool clears = parts_.options.clear_above && parts_.views.front().valid();
    return clears && standing != parts_.targets.end() ? standing->up_C() : Eigen::Vector3d::Zero();
  }

  std::vector<Detection> detections_;
  const Surroundings& known_;
  const Deadline deadline_, half_;
  SceneParts& parts_;
  const ViewClouds views_;
};

}  // namespace

std::unique_ptr<const SceneParts> make_scene_parts(
    const PointCloud& cloud, const std::vector<Detection>& detections, const Gripper& gripper,
    const PlanOptions& options, const Surroundings& known, std::optional<std::vector<Box>> boxes,
    const std::vector<SceneBody>& bodies, double deadline_ms) {
  auto parts = std::make_unique<SceneParts>();
  parts->gripper = gripper;
  parts->options = options;
  parts->reach = hand_reach(gripper, options.approach);
  SceneMaker(cloud, detections, known, deadline_ms, *parts).make(std::move(boxes), bodies);
  return parts;
}

}  // namespace quadrille
