#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace quadrille {

/// Depths that a pinhole camera saw along the rays through the middles of an image's cells. It has
/// no cells if the cloud is fused from several views.
struct Sight {
  /// Pose of frame C in frame V, whose origin is the viewpoint and whose z points into the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Tangents (u, v) of the first cell's corner with the smallest u and v, and edge of a cell as a
  /// tangent.
  Eigen::Array2f corner = Eigen::Array2f::Zero();
  float step = 1.0f;
  int width = 0, height = 0;
  /// Inverse depth per cell, row by row [1/m]; 0 if nothing was seen.
  std::vector<float> w;
};

}  // namespace quadrille
