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

  /// The end of an axis that is nearer to a point, at 2 · axis + upper.
  int nearer_end(int axis, const Eigen::Vector3d& p_A) const {
    return 2 * axis + (p_A[axis] > box_A.center()[axis] ? 1 : 0);
  }

  /// Distance of a point from the surface, negative inside [m]: the rounded box is all that lies
  /// within the radius of a box that is smaller by the radius on each side.
  double distance(const Eigen::Vector3d& p_A) const {
    const Eigen::Vector3d q = beyond_ends(p_A).array() + radius;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
  }

  /// Derivatives of this distance with respect to the six ends, each along its outward direction,
  /// at 2 · axis + upper, and with respect to the radius, which is the last.
  Eigen::Matrix<double, 7, 1> derivatives(const Eigen::Vector3d& p_A) const {
    const Eigen::Vector3d q = beyond_ends(p_A).array() + radius;
    Eigen::Vector3d normal = q.cwiseMax(0.0);
    Eigen::Matrix<double, 7, 1> derivatives = Eigen::Matrix<double, 7, 1>::Zero();
    if (normal.isZero(0.0)) {
      Eigen::Index nearest = 0;
      q.maxCoeff(&nearest);
      normal[nearest] = 1.0;
    } else {
      normal.normalize();
      derivatives[6] = normal.sum() - 1.0;
    }
    for (int axis = 0; axis < 3; ++axis) derivatives[nearer_end(axis, p_A)] = -normal[axis];
    return derivatives;
  }
};

}  // namespace quadrille
