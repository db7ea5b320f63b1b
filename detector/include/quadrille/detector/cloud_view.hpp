#pragma once

#include <Eigen/Core>
#include <span>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// A view of one measured cloud in the frame C of its points, which are stored elsewhere. The
/// points must stay in place and unchanged while the view is used.
struct CloudView {
  CloudView() = default;
  /// Views the points of a cloud. The conversion is implicit so that functions on clouds accept
  /// both.
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
  /// Position of the sensor in frame C [m].
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();

  bool organised() const { return width > 0 && height > 1; }
};

}  // namespace quadrille
