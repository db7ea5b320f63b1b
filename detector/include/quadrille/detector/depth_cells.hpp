#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// A virtual pinhole camera at the viewpoint whose pixels are those of the cloud.
struct PinholeView {
  /// Frame V: origin at the viewpoint, z into the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Tangents (x/z, y/z) of the first pixel's near corner, and the step from pixel to pixel.
  float u0 = 0, v0 = 0, pitch = 0;
  /// Size of the image in pixels.
  int width = 0, height = 0;
};

/// Finds the view of a single-view cloud: pitch and phase of the pixels come from the points.
/// @return nullopt if the cloud is not one view from its viewpoint (fused, all around, too small)
std::optional<PinholeView> find_view(const PointCloud& cloud);

/// The image of a view in square cells of several pixels: mean tangents and mean inverse depth of
/// the points in each cell. Inverse depth is affine in (u, v) on a plane, so averages keep planes.
struct DepthCells {
  PinholeView view;
  /// Pixels per cell edge.
  int pixels = 1;
  int width = 0, height = 0;
  /// Per cell: number of points (0 is empty), mean u, v, and inverse depth w [1/m].
  std::vector<int> count;
  std::vector<float> u, v, w;

  int size() const { return width * height; }
  /// Edge of a cell at inverse depth w [m].
  float metric(float w) const { return view.pitch * static_cast<float>(pixels) / w; }
  /// Position of the mean of cell i in frame V [m].
  Eigen::Vector3f position_V(int i) const {
    return Eigen::Vector3f(u[i], v[i], 1.0f) / w[i];
  }
};

/// True if two cells of the given inverse depths may belong to one surface: their step in depth
/// is that of a surface seen at 75° or less, or within the noise.
bool continuous(const DepthCells& cells, float w_a, float w_b);

/// Averages the points over cells of the given number of pixels; a cell across a depth edge keeps
/// the side with more points.
DepthCells make_depth_cells(const PointCloud& cloud, const PinholeView& view, int pixels);

/// Cells of twice the edge; a cell that would span a depth edge keeps the side with more points.
/// @param keep  per cell, zero to leave it out; empty means all
DepthCells coarser(const DepthCells& fine, const std::vector<char>& keep);

}  // namespace quadrille
