#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace quadrille {

/// One measured cloud in the frame C of its points.
struct PointCloud {
  /// Positions p_C [m]. A missing point of an organised cloud has NaN coordinates.
  std::vector<Eigen::Vector3f> points;
  /// Pixels per row if the cloud is organised (row by row); otherwise 0.
  int width = 0;
  /// Rows if the cloud is organised; otherwise 0.
  int height = 0;
  /// Where the sensor stood, in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  /// Name of frame C.
  std::string frame;
  /// Points that the source announced, before any was dropped.
  std::size_t read = 0;

  bool organised() const { return width > 0 && height > 1; }
};

}  // namespace quadrille
