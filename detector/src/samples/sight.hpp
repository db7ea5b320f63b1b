#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace quadrille {

/// How far a pinhole saw, ray by ray: the rays go through the middles of an image's cells. Without
/// cells for a cloud of many views.
struct Sight {
  /// Frame V: origin at the viewpoint, z into the scene.
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  /// Tangents (u, v) of the first cell's near corner, and the edge of a cell.
  Eigen::Array2f corner = Eigen::Array2f::Zero();
  float step = 1.0f;
  int width = 0, height = 0;
  /// Per cell, row by row, inverse depth [1/m]; 0 where nothing was seen.
  std::vector<float> w;
};

}  // namespace quadrille
