#pragma once

#include <Eigen/Core>

namespace quadrille::scene {

/// Name of frame C in clouds.
inline constexpr const char* kCameraFrame = "camera";

/// A pinhole camera: x right, y down, z forward.
struct Camera {
  int width = 640, height = 480;
  /// Focal length and principal point [pixels].
  double focal = 525.0, cx = 319.5, cy = 239.5;

  /// Makes a camera with the default field of view.
  static Camera of_size(int width, int height) {
    return {width, height, 525.0 * width / 640.0, (width - 1) / 2.0, (height - 1) / 2.0};
  }
  /// Returns the direction of a pixel, with z = 1.
  Eigen::Vector3d ray(int column, int row) const {
    return {(column - cx) / focal, (row - cy) / focal, 1.0};
  }
};

}  // namespace quadrille::scene
