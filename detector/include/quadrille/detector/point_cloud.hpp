#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"

namespace quadrille {

/// Red, green and blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// One measured cloud in the frame C of its points.
struct PointCloud {
  /// Positions p_C [m]. A missing point of an organised cloud has NaN coordinates.
  std::vector<Eigen::Vector3f> points;
  /// The colour of each point, missing ones included; empty if the source has no colours or they
  /// were not requested.
  std::vector<Rgb> colours;
  /// Pixels per row if the cloud is organised (row by row); otherwise 0.
  int width = 0;
  /// Rows if the cloud is organised; otherwise 0.
  int height = 0;
  /// Position of the sensor in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
  /// Name of frame C.
  std::string frame;
  /// Number of points that the source announced, before any was dropped.
  std::size_t read = 0;

  bool organised() const { return width > 0 && height > 1; }
  bool coloured() const { return !colours.empty() && colours.size() == points.size(); }
};

}  // namespace quadrille
