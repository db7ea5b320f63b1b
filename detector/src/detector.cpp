#include "quadrille/detector/detector.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/stage_clock.hpp"
#include "cloud/cloud_check.hpp"
#include "cloud/far_cloud.hpp"
#include "detect_with.hpp"
#include "quadrille/detector/cloud_checks.hpp"
#include "samples/sample_tree.hpp"
#include "views/align.hpp"
#include "views/findings.hpp"
#include "views/joined_samples.hpp"
#include "views/scene.hpp"
#include "views/seen_through.hpp"
#include "views/view_search.hpp"

namespace quadrille {
namespace {

/// Runs all stages on views near the origin.
Findings find_all(std::span<const CloudView> clouds, const DetectorOptions& options,
                  const FindCandidates& find, StageClock& clock) {
  std::vector<ViewSearch> views;
  for (const CloudView& cloud : clouds) {
    if (auto view = search_view(cloud, options, find, clock)) views.push_back(std::move(*view));
  }
  if (views.empty()) return {};
  const Scene scene = join_views(std::move(views), options);
  if (clouds.size() > 1) clock.end("join");
  return measure_scene(scene, options, clock);
}

/// Runs all stages on views anywhere. Those far from the origin are shifted first, since their
/// coordinates leave few digits for the shape.
Findings find_anywhere(std::span<const CloudView> clouds, const Eigen::Vector3d& centre,
                       const DetectorOptions& options, const FindCandidates& find,
                       StageClock& clock) {
  const Eigen::Vector3d shift = shift_to_origin(centre);
  if (shift.isZero(0.0)) return find_all(clouds, options, find, clock);
  std::vector<PointCloud> near;
  for (const CloudView& cloud : clouds) near.push_back(translated(cloud, shift));
  Findings findings =
      find_all(std::vector<CloudView>(near.begin(), near.end()), options, find, clock);
  for (Detection& d : findings.detections) d = translated(std::move(d), -shift);
  for (Box& box : findings.boxes) box.X_CB.pretranslate(-shift);
  for (SceneBody& body : findings.bodies) body.X_CB.pretranslate(-shift);
  return findings;
}

/// Diagonal of the bounding box of the finite points [m].
double diameter_of(const CloudView& cloud) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (p.allFinite()) box.extend(p);
  }
  return box.isEmpty() ? 0.0 : static_cast<double>(box.diagonal().norm());
}

/// Resolves the options that depend on the cloud.
DetectorOptions settled(DetectorOptions options, const CloudView& cloud) {
  if (options.sampling.relative_cell > 0.0) {
    options.sampling.cell = options.sampling.relative_cell * diameter_of(cloud);
  }
  return options;
}

/// The views in which surfaces can be found.
struct UsableViews {
  std::vector<CloudView> clouds;
  /// Their numbers among all views, from 0 on.
  std::vector<std::size_t> numbers;
  /// Middle of the first of them [m].
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
  return usable;
}

/// @param all  number of all views
DetectionResult detect_checked(const UsableViews& views, std::size_t all,
                               const DetectorOptions& given, const FindCandidates& find,
                               DetectionResult result, StageClock& clock) {
  if (views.clouds.empty()) return result;
  const DetectorOptions options = settled(given, views.clouds.front());
  Findings found = find_anywhere(views.clouds, views.centre, options, find, clock);
  result.detections = std::move(found.detections);
  result.boxes = std::move(found.boxes);
  result.bodies = std::move(found.bodies);
  result.points_used = found.points_used;
  for (std::size_t v = 0; v < views.clouds.size(); ++v) {
    const std::string doubt = contradict_viewpoint(views.clouds[v], result.detections);
    if (!doubt.empty()) result.warnings.push_back(of_view(views.numbers[v], all, doubt));
  }
  clock.end("viewpoint");
  return result;
}

DetectionResult detect_all(const FindCandidates& find, std::span<const CloudView> given,
                           const DetectorOptions& options) {
  StageClock clock;
  options.check();
  std::vector<CloudCheck> checks;
  for (const CloudView& cloud : given) checks.push_back(check_cloud(cloud));
  DetectionResult result;
  const UsableViews views = usable_views(given, checks, &result);
  result = detect_checked(views, given.size(), options, find, std::move(result), clock);
  result.timings = clock.timings();
  result.total_ms = clock.total_ms();
  return result;
}

/// A view's depths, and the samples on which it is aligned with others.
struct SeenView {
  Sight sight;
  SurfaceSamples samples;
};

/// Returns nullopt if the cloud is too small, or its viewpoint is not known.
std::optional<SeenView> seen_view(const CloudView& given, const DetectorOptions& options) {
  const CloudCheck check = check_cloud(given);
  if (!check.usable || !given.viewpoint.allFinite()) return std::nullopt;
  const CloudView cloud = check.range.kept(given);
  const std::unique_ptr<CellPyramid> pyramid =
      make_pyramid(cloud, settled(options, cloud).sampling);
  if (!pyramid) return std::nullopt;
  const Mask all(static_cast<std::size_t>(pyramid->size(0)), 1);
  SampleTree tree(*pyramid, pyramid->samples(all, options.threads));
  return SeenView{pyramid->sight(), std::move(tree).take_finest()};
}

/// Drops the marked points of a cloud; those of an organised one become NaN.
void drop(const Mask& dropped, PointCloud* cloud) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < cloud->points.size(); ++k) {
    if (cloud->organised()) {
      if (dropped[k]) {
        cloud->points[k].setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    } else if (!dropped[k]) {
      if (cloud->coloured()) cloud->colours[kept] = cloud->colours[k];
      cloud->points[kept++] = cloud->points[k];
    }
  }
  if (cloud->organised()) return;
  if (cloud->coloured()) cloud->colours.resize(kept);
  cloud->points.resize(kept);
}

/// Drops the points of each view that another view sees through.
void drop_seen_through(std::span<const std::optional<Sight>> sights,
                       std::vector<PointCloud>* views) {
  for (std::size_t v = 0; v < views->size(); ++v) {
    std::vector<Sight> others;
    for (std::size_t u = 0; u < sights.size(); ++u) {
      if (u != v && sights[u]) others.push_back(*sights[u]);
    }
    drop(seen_through((*views)[v], others), &(*views)[v]);
  }
}

}  // namespace

DetectionResult detect(const CloudView& cloud, const DetectorOptions& options) {
  return detect_with({}, cloud, options);
}

DetectionResult detect_with(const FindCandidates& find, const CloudView& cloud,
                            const DetectorOptions& options) {
  return detect_all(find, {&cloud, 1}, options);
}

DetectionResult detect_views(std::span<const PointCloud> views, const DetectorOptions& options) {
  if (views.empty()) throw std::invalid_argument("detect_views: there is no view");
  return detect_all({}, std::vector<CloudView>(views.begin(), views.end()), options);
}

std::vector<Eigen::Isometry3d> align_views(std::vector<PointCloud>* views,
                                           const DetectorOptions& options) {
  options.check();
  std::vector<Eigen::Isometry3d> motions(views->size(), Eigen::Isometry3d::Identity());
  if (views->size() < 2) return motions;
  std::vector<SurfaceSamples> aligned;
  aligned.reserve(views->size());
  std::vector<const SurfaceSamples*> before;
  std::vector<std::optional<Sight>> sights(views->size());
  for (std::size_t v = 0; v < views->size(); ++v) {
    PointCloud& cloud = (*views)[v];
    std::optional<SeenView> view = seen_view(cloud, options);
    if (!view) continue;
    if (!before.empty()) {
      const std::vector<int> no_cells(before.size(), 0);
      const std::optional<Eigen::Isometry3d> motion = align(
          view->samples, cloud.viewpoint, joined_samples(before, no_cells, 0.0), options.views);
      if (!motion) continue;
      motions[v] = *motion;
      cloud = moved(std::move(cloud), motions[v]);
      view->sight.X_VC = view->sight.X_VC * motions[v].inverse().cast<float>();
    }
    before.push_back(&aligned.emplace_back(moved(std::move(view->samples), motions[v])));
    sights[v] = std::move(view->sight);
  }
  drop_seen_through(sights, views);
  return motions;
}

}  // namespace quadrille
