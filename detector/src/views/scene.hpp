#pragma once

#include <memory>
#include <vector>

#include "quadrille/detector/options.hpp"
#include "views/view_search.hpp"

namespace quadrille {

/// A view, and the number of its first cell among the cells of all views.
struct ViewCells {
  CloudView cloud;
  std::unique_ptr<CellPyramid> pyramid;
  int first = 0;

  int size() const { return pyramid->size(0); }
};

/// The surfaces of a scene in frame C, with the samples of all its views.
struct Scene {
  std::vector<ViewCells> views;
  /// The samples on which the planes were found; of each plane, its samples; and for each finest
  /// cell of all views its plane, −1 for none.
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  std::vector<int> plane_of_cell;
  /// The samples beside the planes, and the surfaces among them. A sample's source is a cell of all
  /// views.
  SurfaceSamples finest;
  std::vector<Surface> surfaces;
  SceneContext context;

  /// The viewpoint of the first view.
  const Eigen::Vector3d& viewpoint() const { return views.front().cloud.viewpoint; }
};

/// The scene of a single view.
Scene scene_of(ViewSearch view);

/// Joins several views of one scene, at least one. The surfaces of each view are the candidates
/// for those of the scene: each is refitted to what it explains in all views, judged by the
/// evidence of all views, and joined with others that the same quadric explains.
Scene join_views(std::vector<ViewSearch> views, const DetectorOptions& options);

}  // namespace quadrille
