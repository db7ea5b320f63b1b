#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cloud/cloud_check.hpp"
#include "quadrille/detector/detector.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/sample_tree.hpp"
#include "views/align.hpp"
#include "views/joined_samples.hpp"
#include "views/seen_through.hpp"

namespace quadrille {
namespace {

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
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
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
