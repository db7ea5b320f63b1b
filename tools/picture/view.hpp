#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// The pinhole that a picture is drawn through; frame V: x right, y down, z forward.
struct View {
  Eigen::Isometry3d X_VC = Eigen::Isometry3d::Identity();
  /// Focal length and principal point [pixels].
  double focal = 1.0, cx = 0.0, cy = 0.0;
  int width = 0, height = 0;
  /// Points further than this from the middle are left out [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double reach = std::numeric_limits<double>::infinity();

  bool holds(const Eigen::Vector2d& p) const {
    return p.minCoeff() >= 0.0 && p.x() < width && p.y() < height;
  }
  /// Pixel coordinates of a point; nullopt if it lies behind the eye.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;
  /// Direction of a pixel in frame V, with z = 1.
  Eigen::Vector3d ray(double x, double y) const { return {(x - cx) / focal, (y - cy) / focal, 1}; }
  /// The same view in an image of another size.
  View scaled(double scale) const;
};

/// From where a picture is drawn.
enum class ViewSide { kCamera, kTop, kSide };

/// What a view from above or from aside is made of.
struct ViewSubject {
  /// What is to be seen; the whole cloud if empty.
  Eigen::AlignedBox3d box_C;
  /// What the view has to hold beside the cloud, such as hands.
  std::vector<Eigen::Vector3d> more_C;
  /// Normals of planes, towards the sensor, with the number of points on each; the largest that
  /// looks upward tells where up is.
  std::vector<std::pair<Eigen::Vector3d, int>> planes_C;
};

/// A view from the cloud's viewpoint that the cloud fills; from outside if the viewpoint is amidst
/// the points.
/// @param width  of the picture [pixels]; its height follows from the cloud
View fit_view(const PointCloud& cloud, int width);

/// A view from above, or from the right of the camera, of the subject.
View fit_view(const PointCloud& cloud, int width, ViewSide side, const ViewSubject& subject);

/// What a view shows of a cloud, row by row.
struct CloudImage {
  /// Depth along z [m]; 0 where there is no point.
  std::vector<float> depth;
  /// The colour of the point that each pixel shows; empty if the cloud has no colours.
  std::vector<Rgb> colours;
};

/// The nearest points of the cloud in a view. Points cover as many pixels as it takes to close the
/// gaps between neighbours.
CloudImage cloud_image(const PointCloud& cloud, const View& view);

}  // namespace quadrille
