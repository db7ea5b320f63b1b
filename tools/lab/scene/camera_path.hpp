#pragma once

#include <Eigen/Geometry>

#include "lab/scene/layout.hpp"

namespace quadrille::scene {

/// The path of a camera about the bodies on the table of a layout.
///
/// The camera moves on a sphere about the middle of the bodies, which it looks at with its rows
/// level. It turns about the vertical from one side of the still camera's place to the other, by 60
/// degrees on each, and rises a little. In less than six seconds it turns by less, so that it is
/// never faster than a camera on an arm. It starts and ends at rest, with the least jerk in
/// between.
///
/// Angles are given by the tangents of their halves, since their cosines and sines then need no
/// functions that differ between machines.
class CameraPath {
 public:
  /// @param layout  the bodies, and the pose of the still camera
  /// @param duration  of the motion, > 0 [s]
  CameraPath(const Layout& layout, double duration);

  /// Returns the camera's pose in the layout's frame W. The camera is at rest before time 0 and
  /// after the duration [s].
  Eigen::Isometry3d pose_at(double time) const;

  /// The point of frame W that the camera looks at [m].
  const Eigen::Vector3d& target() const { return target_; }

 private:
  double duration_;
  Eigen::Vector3d target_;
  /// Distance of the camera from the target [m].
  double distance_;
  /// The still camera's direction from the target on the table, and the tangent of half its
  /// elevation.
  Eigen::Vector2d heading_;
  double elevation_;
  /// Tangent of half the angle between the still camera and each end of the path.
  double side_;
};

}  // namespace quadrille::scene
