#include "lab/scene/pose_error.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::scene {

PoseError::PoseError(const PoseErrorSize& size, double duration, Random* random)
    : size_(size), duration_(duration), seconds_(static_cast<std::size_t>(duration) + 2) {
  for (Vector6d& error : seconds_) {
    for (double& value : error) value = random->normal();
  }
}

Eigen::Isometry3d PoseError::at(double time) const {
  const double t = std::clamp(time, 0.0, duration_);
  const auto second = static_cast<std::size_t>(t);
  const double u = t - std::floor(t);
  const Vector6d unit = ((1.0 - u) * seconds_[second] + u * seconds_[second + 1]) /
                        std::sqrt((1.0 - u) * (1.0 - u) + u * u);
  // The quaternion (1, w / 2) turns by |w|, to the third order of that small angle.
  const Eigen::Vector3d half = 0.5 * size_.turn * unit.tail<3>();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() =
      Eigen::Quaterniond(1.0, half.x(), half.y(), half.z()).normalized().toRotationMatrix();
  X.translation() = size_.shift * unit.head<3>();
  return X;
}

}  // namespace quadrille::scene
