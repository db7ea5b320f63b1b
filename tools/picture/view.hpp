#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// The pinhole camera through which a picture is drawn; frame V: x right, y down, z forward.
struct View {
  Eigen::Isometry3d X_VC = Eigen::Isometry3d::Identity();
  /// Focal length and principal point [pixels].
  double focal = 1.0, cx = 0.0, cy = 0.0;
  int width = 0, height = 0;
  /// Centre and radius of the visible part; points farther away are left out [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double reach = std::numeric_limits<double>::infinity();

  bool holds(const Eigen::Vector2d& p) const {
    return p.minCoeff() >= 0.0 && p.x() < width && p.y() < height;
  }
  /// Returns the pixel coordinates of a point; nullopt if it lies behind the eye.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;
  /// Returns the direction of a pixel in frame V, with z = 1.
  Eigen::Vector3d ray(double x, double y) const { return {(x - cx) / focal, (y - cy) / focal, 1}; }
  /// Returns the same view in an image of another size.
  View scaled(double scale) const;
};

/// The direction from which a picture is drawn.
enum class ViewSide { kCamera, kTop, kSide };

/// The subject of a view from above or from the side.
struct ViewSubject {
  /// Bounds of the subject; if empty, the whole cloud is the subject.
  Eigen::AlignedBox3d box_C;
  /// Further points that the view has to hold beside the cloud, such as hands.
  std::vector<Eigen::Vector3d> more_C;
  /// Normals of planes, towards the sensor, with the number of points on each. The largest plane
  /// that faces upward defines the upward direction.
  std::vector<std::pair<Eigen::Vector3d, int>> planes_C;
};

/// Returns a view from the cloud's viewpoint that the cloud fills; from outside if the viewpoint
/// lies among the points.
/// @param width  width of the picture [pixels]; the height follows from the cloud
View fit_view(const PointCloud& cloud, int width);

/// Returns a view of the subject from above, or from the right of the camera.
View fit_view(const PointCloud& cloud, int width, ViewSide side, const ViewSubject& subject);

/// The image of a cloud in a view, row by row.
struct CloudImage {
  /// Depth along z [m]; 0 if the pixel shows no point.
  std::vector<float> depth;
  /// Colour of the point that each pixel shows; empty if the cloud has no colours.
  std::vector<Rgb> colours;
};

/// Draws the nearest points of the cloud in a view. Each point covers as many pixels as needed to
/// close the gaps between neighbours.
CloudImage cloud_image(const PointCloud& cloud, const View& view);

}  // namespace quadrille
