#include "scene/scene_targets.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "space/map_limits.hpp"
#include "space/support.hpp"

namespace quadrille {
namespace {

/// The view with the most points in the box around a target.
/// @param cloud  the points of all views, one view after the other
std::size_t best_view(const Target& target, const ViewClouds& views, const CloudRuns& cloud) {
  if (views.size() == 1) return 0;
  std::vector<std::size_t> counts(views.size(), 0), ends;
  for (const ViewClouds::View& view : views) {
    ends.push_back((ends.empty() ? 0 : ends.back()) + view.things->points.size());
  }
  std::size_t view = 0;
  cloud.each_in(target.body.bounds_C().cast<float>(), [&](std::size_t n) {
    while (n >= ends[view]) ++view;
    ++counts[view];
  });
  return static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

void add(ChosenTargets chosen, SceneParts* parts) {
  std::move(chosen.targets.begin(), chosen.targets.end(), std::back_inserter(parts->targets));
  for (const auto& [id, why] : chosen.refused) parts->refuse(id, why);
  parts->refusals[Refusal::kUnmeasured] += chosen.unmeasured;
}

/// Refuses targets that do not fit into one map, so that a body far away does not spoil the map
/// for the others.
void drop_far_targets(const Eigen::Vector3d& viewpoint, SceneParts* parts) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Target& target : parts->targets) boxes.push_back(around(target.body, parts->reach));
  const std::vector<std::size_t> far = find_far_boxes(boxes, viewpoint, parts->options.resolution);
  for (auto n = far.rbegin(); n != far.rend(); ++n) {
    const auto target = parts->targets.begin() + static_cast<std::ptrdiff_t>(*n);
    parts->refuse(target->id, Refusal::kFar, target->wanted);
    parts->targets.erase(target);
  }
  if (far.empty()) return;
  parts->warnings.push_back(
      "targets that are too large, or too far from the viewpoint, to be mapped with the "
      "others: " +
      std::to_string(far.size()));
}

}  // namespace

void choose_scene_targets(const ViewClouds& views, const std::vector<Detection>& detections,
                          const std::vector<SceneBody>& bodies, const Surroundings& known,
                          const Deadline& deadline, SceneParts* parts) {
  const CloudRuns cloud(views.all());
  add(choose_targets(cloud, detections, parts->views, parts->gripper, parts->options, deadline),
      parts);
  add(choose_boxes(cloud, parts->boxes, detections, parts->gripper, parts->options, deadline),
      parts);
  std::vector<Target> unshaped =
      choose_unshaped(bodies, parts->targets, detections, parts->options);
  std::move(unshaped.begin(), unshaped.end(), std::back_inserter(parts->targets));
  add_bodies(bodies, detections, &parts->targets);
  for (const SceneBody& body : bodies) {
    for (const int part : body.parts) parts->body_of.emplace(part, body.id);
  }
  for (Target& target : parts->targets) {
    target.view = best_view(target, views, cloud);
    if (!known.support) continue;
    target.supports.push_back(plane_of(*known.support, target.body.centre_C()));
  }
  drop_far_targets(views.first().viewpoint, parts);
}

}  // namespace quadrille
