#include "scene/make_scene_parts.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/deadline.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "scene/map_space.hpp"
#include "scene/scene_shapes.hpp"
#include "scene/scene_targets.hpp"
#include "scene/view_clouds.hpp"

namespace quadrille {
namespace {

using Clock = std::chrono::steady_clock;

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
    stage("shapes", [&] { add_shapes(detections_, &parts_); });
    if (views_.first().points.empty()) warn("the cloud is empty");
    check_support();
    const PlanOptions& options = parts_.options;
    stage("view", [&] {
      std::vector<std::optional<DepthView>> made(views_.size());
      parallel_for(static_cast<int>(made.size()), options.threads, [&](int v) {
        made[v].emplace(*views_[v].seen, options.baseline, options.resolution);
      });
      std::vector<DepthView> views;
      views.reserve(made.size());
      for (std::optional<DepthView>& view : made) views.push_back(*std::move(view));
      parts_.shared_views = std::make_shared<const std::vector<DepthView>>(std::move(views));
      parts_.views = *parts_.shared_views;
    });
    const bool seen_so = has_viewpoint();
    if (seen_so && !sighted()) {
      warn("no point lies before the viewpoint: all space counts as unknown");
    } else if (seen_so && !parts_.views.front().valid()) {
      warn("the cloud shows nothing: the plan is on what the further views show");
    }
    if (seen_so) {
      stage("targets",
            [&] { choose_scene_targets(views_, detections_, bodies, known_, half_, &parts_); });
    }
    if (deadline_.passed()) {
      drop_all_targets();
    } else {
      stage("occupancy", [&] { map_space(views_, known_, &parts_); });
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
      parts_.refuse(d.id, Refusal::kSurplus, is_wanted(d, parts_.options));
    }
    std::sort(order.begin(), surplus);
    std::vector<Detection> kept;
    for (auto index = order.begin(); index != surplus; ++index) kept.push_back(detections_[*index]);
    detections_ = std::move(kept);
    warn("of " + std::to_string(all) + " detections only the " + std::to_string(most) +
         " with the best score are planned on (planner.max_detections)");
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
      parts_.refuse(d.id, Refusal::kViewpoint);
    }
    return false;
  }

  /// True if a view has points before its viewpoint.
  bool sighted() const {
    return std::any_of(parts_.views.begin(), parts_.views.end(),
                       [](const DepthView& view) { return view.valid(); });
  }

  /// Drops all targets, since mapping the space around them takes long and is of no use if there is
  /// no time left to try them.
  void drop_all_targets() {
    for (const Target& target : parts_.targets) {
      parts_.refuse(target.id, Refusal::kDeadline, target.wanted);
    }
    parts_.targets.clear();
    warn("the deadline passed before space was mapped: the plan has no map");
  }

  std::vector<Detection> detections_;
  const Surroundings& known_;
  /// Targets are chosen within half of the time, which leaves the other half to try them.
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
