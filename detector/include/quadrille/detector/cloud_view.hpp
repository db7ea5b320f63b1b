#pragma once

#include <Eigen/Core>
#include <span>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// One measured cloud whose points lie elsewhere, in the frame C of its points. Whoever makes one
/// keeps the points in place, and does not write to them, as long as it is used.
struct CloudView {
  CloudView() = default;
  /// The points of a cloud. Implicit, so that what reads clouds takes either.
  CloudView(const PointCloud& cloud)  // NOLINT(google-explicit-constructor)
      : points(cloud.points),
        width(cloud.width),
        height(cloud.height),
        viewpoint(cloud.viewpoint) {}

  /// Positions p_C [m]. A missing point of an organised cloud has NaN coordinates; points farther
  /// than kMaxRange from the viewpoint count as missing (see check_range()).
  std::span<const Eigen::Vector3f> points;
  /// Pixels per row if the cloud is organised (row by row); otherwise 0.
  int width = 0;
  /// Rows if the cloud is organised; otherwise 0.
  int height = 0;
  /// Where the sensor stood, in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();

  bool organised() const { return width > 0 && height > 1; }
};

}  // namespace quadrille
