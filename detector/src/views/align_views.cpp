#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cloud/drop_points.hpp"
#include "quadrille/detector/detector.hpp"
#include "views/align.hpp"
#include "views/joined_samples.hpp"
#include "views/seen_through.hpp"
#include "views/seen_view.hpp"

namespace quadrille {
namespace {

/// Drops the points of each view that another view sees through.
void drop_seen_through(std::span<const std::optional<Sight>> sights,
                       std::vector<PointCloud>* views) {
  for (std::size_t v = 0; v < views->size(); ++v) {
    PointCloud& cloud = (*views)[v];
    Mask dropped(cloud.points.size(), 0);
    for (std::size_t u = 0; u < sights.size(); ++u) {
      if (u == v || !sights[u]) continue;
      const Sight own = sights[v].value_or(Sight{});
      const Mask through =
          points_seen_through(cloud.points, own, cells_seen_through(own, *sights[u]), *sights[u]);
      for (std::size_t n = 0; n < dropped.size(); ++n) dropped[n] |= through[n];
    }
    drop_points(dropped, &cloud);
  }
}

}  // namespace

std::vector<Eigen::Isometry3d> align_views(std::vector<PointCloud>* views,
                                           const DetectorOptions& options) {
  options.check();
  std::vector<Eigen::Isometry3d> motions(views->size(), Eigen::Isometry3d::Identity());
  if (views->size() < 2) return motions;
  std::vector<SamplesOnDemand> aligned;
  aligned.reserve(views->size());
  std::vector<const SurfaceSamples*> before;
  std::vector<std::optional<Sight>> sights(views->size());
  for (std::size_t v = 0; v < views->size(); ++v) {
    PointCloud& cloud = (*views)[v];
    std::optional<SeenView> view = seen_view(cloud, options);
    if (!view) continue;
    if (!before.empty()) {
      const std::optional<Eigen::Isometry3d> motion =
          align(view->samples.get(), cloud.viewpoint, joined_places(before), options.views);
      if (!motion) continue;
      motions[v] = *motion;
      cloud = moved(std::move(cloud), motions[v]);
      view->sight.X_VC = view->sight.X_VC * motions[v].inverse().cast<float>();
    }
    view->samples.move(motions[v]);
    before.push_back(&aligned.emplace_back(std::move(view->samples)).get());
    sights[v] = std::move(view->sight);
  }
  drop_seen_through(sights, views);
  return motions;
}

}  // namespace quadrille
