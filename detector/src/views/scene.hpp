#pragma once

#include <memory>
#include <vector>

#include "planes/planes.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// A view, and the number of its first cell among the finest cells of all views. The cloud's points
/// must outlive it.
struct ViewCells {
  CloudView cloud;
  std::unique_ptr<CellPyramid> pyramid;
  int first = 0;

  int size() const { return pyramid->size(0); }
};

/// The surfaces of a scene in frame C, and the samples of all its views.
struct Scene {
  /// At least one.
  std::vector<ViewCells> views;
  /// The samples on which the planes were found, and for each finest cell of all views its plane,
  /// −1 for none.
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  std::vector<int> plane_of_cell;
  /// The samples beside the planes, and the surfaces that were found among them. A sample's source
  /// is one of the finest cells of all views.
  SurfaceSamples finest;
  std::vector<Surface> surfaces;
  SceneContext context;

  /// The viewpoint of the first view.
  const Eigen::Vector3d& viewpoint() const { return views.front().cloud.viewpoint; }
};

}  // namespace quadrille
