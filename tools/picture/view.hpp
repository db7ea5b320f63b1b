#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// The pinhole that a picture is drawn through; frame V: x right, y down, z forward.
struct View {
  Eigen::Isometry3d X_VC = Eigen::Isometry3d::Identity();
  /// Focal length and principal point [pixels].
  double focal = 1.0, cx = 0.0, cy = 0.0;
  int width = 0, height = 0;

  /// Pixel coordinates of a point; nullopt if it lies behind the eye.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;
  /// Direction of a pixel in frame V, with z = 1.
  Eigen::Vector3d ray(double x, double y) const { return {(x - cx) / focal, (y - cy) / focal, 1}; }
};

/// A view from the cloud's viewpoint that the cloud fills; from outside if the viewpoint is amidst
/// the points.
/// @param width  of the picture [pixels]; its height follows from the cloud
View fit_view(const PointCloud& cloud, int width);

/// Depth along z of the cloud in a view [m], row by row; 0 where there is no point. Points cover as
/// many pixels as it takes to close the gaps between neighbours.
std::vector<float> depth_image(const PointCloud& cloud, const View& view);

}  // namespace quadrille
