#include "space/obstacle_points.hpp"

#include <algorithm>

namespace quadrille {
namespace {

// Number of points that are tested at once.
constexpr Eigen::Index kAtOnce = 64;

}  // namespace

ObstaclePoints::ObstaclePoints(const std::vector<Eigen::Vector3d>& points_C)
    : points_C_(static_cast<Eigen::Index>(points_C.size()), 3) {
  for (Eigen::Index i = 0; i < points_C_.rows(); ++i) {
    points_C_.row(i) = points_C[static_cast<std::size_t>(i)].cast<float>().transpose();
  }
}

bool ObstaclePoints::meet(const OrientedBox& box) const {
  const Eigen::Matrix3f R_CB = box.R_CB.cast<float>();
  const Eigen::Array3f middle_B = (box.R_CB.transpose() * box.p_CB).cast<float>().array();
  const Eigen::Array3f half = box.half.cast<float>().array();
  for (Eigen::Index first = 0; first < points_C_.rows(); first += kAtOnce) {
    const auto some = points_C_.middleRows(first, std::min(kAtOnce, points_C_.rows() - first));
    Eigen::Array<bool, Eigen::Dynamic, 1, 0, kAtOnce, 1> inside;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Array<float, Eigen::Dynamic, 1, 0, kAtOnce, 1> offset =
          (some * R_CB.col(axis)).array() - middle_B[axis];
      if (axis == 0) {
        inside = offset.abs() <= half[axis];
      } else {
        inside = inside && offset.abs() <= half[axis];
      }
      // Most points are far away, and one axis shows it.
      if (!inside.any()) break;
    }
    if (inside.any()) return true;
  }
  return false;
}

}  // namespace quadrille
