#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lab/scene/random.hpp"

namespace quadrille::scene {

/// The size of the error of a camera's pose as a robot knows it: standard deviations of its
/// position along each axis [m], and of its direction about each axis [rad].
struct PoseErrorSize {
  double shift = 0.0, turn = 0.0;
};

/// An error of a camera's pose that varies slowly: it is drawn anew for each second, and changes
/// from one to the next without changing its size.
class PoseError {
 public:
  /// @param duration  time for which errors are drawn [s]
  PoseError(const PoseErrorSize& size, double duration, Random* random);

  /// Returns the pose, in the camera's true frame, of the frame in which the robot thinks that the
  /// camera is. Before time 0 and after the duration the error is constant [s].
  Eigen::Isometry3d at(double time) const;

 private:
  using Vector6d = Eigen::Matrix<double, 6, 1>;

  PoseErrorSize size_;
  double duration_;
  /// Errors of unit variance at whole seconds: of the position, and of the direction.
  std::vector<Vector6d> seconds_;
};

}  // namespace quadrille::scene
