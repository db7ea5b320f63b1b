#include "space/obstacle_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "base/point_buckets.hpp"

namespace quadrille {
namespace {

// Edge of the cubes that gather neighbouring points, and the radius of the ball around a cube, with
// a reserve for rounding [m].
constexpr double kEdge = 0.02, kRadius = 0.0175;
// Number of points, or of cubes, that are tested at once.
constexpr Eigen::Index kAtOnce = 64;

}  // namespace

ObstaclePoints::ObstaclePoints(const std::vector<Eigen::Vector3d>& points_C)
    : points_C_(std::ssize(points_C), 3) {
  const PointBuckets cubes(points_C, kEdge);
  const Eigen::Index count = std::ssize(cubes.keys());
  centres_C_.resize(count, 3);
  first_.push_back(0);
  for (Eigen::Index n = 0; n < count; ++n) {
    Eigen::Index end = first_.back();
    Eigen::AlignedBox3d around;
    for (const int i : cubes.members(static_cast<std::size_t>(n))) {
      points_C_.row(end++) = points_C[i].cast<float>().transpose();
      around.extend(points_C[i]);
    }
    centres_C_.row(n) = around.center().cast<float>().transpose();
    first_.push_back(end);
  }
}

/// Calls visit(n) for each point n, of a range of points, in a box, until one call returns true.
/// @return whether one did
template <class Visit>
bool ObstaclePoints::any_inside(const Points& points_C, Eigen::Index first, Eigen::Index end,
                                const OrientedBox& box, Visit&& visit) {
  const Eigen::Matrix3f R_CB = box.R_CB.cast<float>();
  const Eigen::Array3f middle_B = (box.R_CB.transpose() * box.p_CB).cast<float>().array();
  const Eigen::Array3f half = box.half.cast<float>().array();
  for (; first < end; first += kAtOnce) {
    const auto some = points_C.middleRows(first, std::min(kAtOnce, end - first));
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
    for (Eigen::Index n = 0; n < inside.size(); ++n) {
      if (inside[n] && visit(first + n)) return true;
    }
  }
  return false;
}

bool ObstaclePoints::meet(const OrientedBox& box) const {
  const auto is_point = [](Eigen::Index) { return true; };
  return any_inside(centres_C_, 0, centres_C_.rows(), box.inflated(kRadius), [&](Eigen::Index n) {
    return any_inside(points_C_, first_[n], first_[n + 1], box, is_point);
  });
}

}  // namespace quadrille
