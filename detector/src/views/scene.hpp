#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "boxes/directions_on_demand.hpp"
#include "planes/planes.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The finest cells of a view: with its points, if it is the newest one or given beside it, and
/// without them if it is kept from earlier.
struct ViewCells {
  /// The points, which must outlive this, and their cells; no points and null for a kept view. Only
  /// the first view's viewpoint counts.
  CloudView cloud;
  std::shared_ptr<const CellPyramid> pyramid;
  /// The points by their directions; null for a kept view.
  std::shared_ptr<DirectionsOnDemand> directions;
  /// The scatter in each cell of a kept view [m²]; see scatter_in_cells().
  std::vector<Eigen::Matrix3f> scatter;
  /// The boxes that a kept view showed, in frame C.
  std::vector<Box> boxes;
  /// The time between the view and the newest one [s].
  double age = 0.0;
  /// The number of the view's first cell among the finest cells of all views.
  int first = 0;

  bool has_points() const { return pyramid != nullptr; }
  int size() const { return has_points() ? pyramid->size(0) : static_cast<int>(scatter.size()); }
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
