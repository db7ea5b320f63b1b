#include "quadrille/detector/detector.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/stage_clock.hpp"
#include "cloud/cloud_check.hpp"
#include "cloud/far_cloud.hpp"
#include "cloud/viewpoint_check.hpp"
#include "detect_with.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "views/findings.hpp"
#include "views/join_views.hpp"
#include "views/search_view.hpp"

namespace quadrille {
namespace {

/// How surfaces are found in a view, how views are joined, and who is told of the stages.
struct Ways {
  FindCandidates find;
  JoinScenes join;
  StageWatch watch;
};

/// Runs all stages on views near the origin.
/// @param shift  what was added to all points [m]
Findings find_all(std::span<const CloudView> clouds, const Eigen::Vector3d& shift,
                  const DetectorOptions& options, const Ways& ways, StageClock& clock) {
  std::vector<Scene> views;
  for (const CloudView& cloud : clouds) {
    if (auto view = search_view(cloud, options, ways.find, clock))
      views.push_back(std::move(*view));
  }
  const std::optional<Scene> scene = ways.join(std::move(views), shift);
  if (!scene) return {};
  if (scene->views.size() > 1) clock.end("join");
  return measure_scene(*scene, options, clock);
}

/// Runs all stages on views anywhere. Those far from the origin are shifted first, since their
/// coordinates leave few digits for the shape.
Findings find_anywhere(std::span<const CloudView> clouds, const Eigen::Vector3d& centre,
                       const DetectorOptions& options, const Ways& ways, StageClock& clock) {
  const Eigen::Vector3d shift = shift_to_origin(centre);
  if (shift.isZero(0.0)) return find_all(clouds, shift, options, ways, clock);
  std::vector<PointCloud> near;
  for (const CloudView& cloud : clouds) near.push_back(translated(cloud, shift));
  Findings findings =
      find_all(std::vector<CloudView>(near.begin(), near.end()), shift, options, ways, clock);
  for (Detection& d : findings.detections) d = translated(std::move(d), -shift);
  for (Box& box : findings.boxes) box.X_CB.pretranslate(-shift);
  for (SceneBody& body : findings.bodies) body.X_CB.pretranslate(-shift);
  return findings;
}

/// The views in which surfaces can be found.
struct UsableViews {
  std::vector<CloudView> clouds;
  /// Their numbers among all views, from 0 on.
  std::vector<std::size_t> numbers;
  /// Middle of the first of them [m]; of none, the viewpoint from which nothing was seen.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// Says which of several views a warning is about.
std::string of_view(std::size_t view, std::size_t views, const std::string& warning) {
  return views == 1 ? warning : "view " + std::to_string(view + 1) + ": " + warning;
}

/// Chooses the views with usable points, and notes what the checks say.
UsableViews usable_views(std::span<const CloudView> given, std::span<const CloudCheck> checks,
                         DetectionResult* result) {
  UsableViews usable;
  for (std::size_t v = 0; v < given.size(); ++v) {
    result->points_finite += checks[v].range.near;
    for (const std::string& warning : checks[v].warnings) {
      result->warnings.push_back(of_view(v, given.size(), warning));
    }
    if (!checks[v].usable) continue;
    if (usable.clouds.empty()) usable.centre = checks[v].centre;
    usable.clouds.push_back(checks[v].range.kept(given[v]));
    usable.numbers.push_back(v);
  }
  const Eigen::Vector3d& eye = given.front().viewpoint;
  if (usable.clouds.empty() && eye.allFinite()) usable.centre = eye;
  return usable;
}

/// Rounds what messages and files hold to fewer digits.
void round_poses(Findings* found) {
  for (Detection& d : found->detections) {
    d.Q_C = Quadric(d.Q_C.coefficients());
    d.X_CQ = rounded(d.X_CQ);
  }
  for (Box& box : found->boxes) box.X_CB = rounded(box.X_CB);
  for (SceneBody& body : found->bodies) body.X_CB = rounded(body.X_CB);
}

/// @param all  number of all views
DetectionResult detect_checked(const UsableViews& views, std::size_t all,
                               const DetectorOptions& options, const Ways& ways,
                               DetectionResult result, StageClock& clock) {
  Findings found = find_anywhere(views.clouds, views.centre, options, ways, clock);
  round_poses(&found);
  result.detections = std::move(found.detections);
  result.boxes = std::move(found.boxes);
  result.bodies = std::move(found.bodies);
  result.points_used = found.points_used;
  for (std::size_t v = 0; v < views.clouds.size(); ++v) {
    const std::string doubt =
        contradict_viewpoint_in_range(views.clouds[v], result.detections,
                                      views.numbers[v] == 0 ? kNameViewpoint : kFurtherViewpoint);
    if (!doubt.empty()) result.warnings.push_back(of_view(views.numbers[v], all, doubt));
  }
  clock.end("viewpoint");
  return result;
}

DetectionResult detect_all(const Ways& ways, std::span<const CloudView> given,
                           const DetectorOptions& options) {
  StageClock clock(ways.watch);
  options.check();
  std::vector<CloudCheck> checks;
  for (const CloudView& cloud : given) checks.push_back(check_cloud(cloud));
  DetectionResult result;
  const UsableViews views = usable_views(given, checks, &result);
  result = detect_checked(views, given.size(), options, ways, std::move(result), clock);
  result.timings = clock.timings();
  result.total_ms = clock.total_ms();
  return result;
}

JoinScenes join_by(const DetectorOptions& options) {
  return [&options](std::vector<Scene> scenes, const Eigen::Vector3d&) -> std::optional<Scene> {
    if (scenes.empty()) return std::nullopt;
    return join_scenes(std::move(scenes), options);
  };
}

}  // namespace

DetectionResult detect(const CloudView& cloud, const DetectorOptions& options) {
  return detect_with({}, cloud, options);
}

DetectionResult detect_with(const FindCandidates& find, const CloudView& cloud,
                            const DetectorOptions& options) {
  return detect_all({find, join_by(options), {}}, {&cloud, 1}, options);
}

DetectionResult detect_watched(StageWatch watch, const CloudView& cloud,
                               const DetectorOptions& options) {
  return detect_all({{}, join_by(options), std::move(watch)}, {&cloud, 1}, options);
}

DetectionResult detect_joined(const JoinScenes& join, std::span<const CloudView> views,
                              const DetectorOptions& options) {
  return detect_all({{}, join, {}}, views, options);
}

DetectionResult detect_views(std::span<const PointCloud> views, const DetectorOptions& options) {
  if (views.empty()) throw std::invalid_argument("detect_views: there is no view");
  return detect_joined(join_by(options), std::vector<CloudView>(views.begin(), views.end()),
                       options);
}

}  // namespace quadrille
