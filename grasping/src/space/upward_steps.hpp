#pragma once

#include <Eigen/Core>
#include <cmath>

namespace quadrille {

/// How the voxels of a grid stand on each other along a direction upwards: layer by layer along the
/// axis nearest to it, each voxel on the one below it on a straight line. The sideways shift is
/// rounded as a whole, so that rounding errors do not add up.
class UpwardSteps {
 public:
  /// @param up_C  unit vector upwards; zero if there is none
  /// @param size  of the grid [voxels]
  UpwardSteps(const Eigen::Vector3d& up_C, const Eigen::Vector3i& size) {
    known_ = up_C.cwiseAbs().maxCoeff(&axis_) > 0.5;
    if (!known_) return;
    layers_ = size[axis_];
    rises_ = up_C[axis_] > 0.0;
    slope_ = up_C / std::abs(up_C[axis_]);
  }

  /// False if there is no direction upwards.
  bool known() const { return known_; }
  /// The axis along which layers are counted, and their number.
  int axis() const { return axis_; }
  int layers() const { return layers_; }
  /// Returns the coordinate along the axis of the layer with number n, counted from below [voxels].
  int place(int n) const { return rises_ ? n : layers_ - 1 - n; }
  /// Returns the number, counted from below, of the layer at a coordinate along the axis.
  int number(int place) const { return rises_ ? place : layers_ - 1 - place; }
  /// The offset of a voxel in the n-th layer, n > 0, from the one on which it stands.
  Eigen::Vector3i step(int n) const { return shift(n) - shift(n - 1); }

 private:
  Eigen::Vector3i shift(int n) const { return (n * slope_).array().round().cast<int>().matrix(); }

  bool known_ = false, rises_ = false;
  int axis_ = 0, layers_ = 0;
  Eigen::Vector3d slope_ = Eigen::Vector3d::Zero();
};

}  // namespace quadrille
