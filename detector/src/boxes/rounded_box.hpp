#pragma once

#include <Eigen/Geometry>
#include <algorithm>

namespace quadrille {

/// A box along the axes of frame A whose edges and corners are rounded with one radius [m].
struct RoundedBox {
  Eigen::AlignedBox3d box_A;
  double radius = 0.0;

  /// How far a point lies beyond the nearer end of each axis, negative between the ends [m].
  Eigen::Vector3d beyond_ends(const Eigen::Vector3d& p_A) const {
    return (p_A - box_A.max()).cwiseMax(box_A.min() - p_A);
  }

  /// Distance of a point from the surface, negative inside [m]: the rounded box is all that lies
  /// within the radius of a box that is smaller by the radius on each side.
  double distance(const Eigen::Vector3d& p_A) const {
    const Eigen::Vector3d q = beyond_ends(p_A).array() + radius;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
  }
};

}  // namespace quadrille
