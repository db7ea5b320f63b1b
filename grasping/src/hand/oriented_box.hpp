#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace quadrille {

/// A box of any orientation, in frame C. Its own frame B lies at its centre, with axes along its
/// edges.
struct OrientedBox {
  Eigen::Matrix3d R_CB = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_CB = Eigen::Vector3d::Zero();
  /// Half of each side length [m].
  Eigen::Vector3d half = Eigen::Vector3d::Zero();

  /// Returns the box with each face moved outward by r [m].
  OrientedBox inflated(double r) const { return {R_CB, p_CB, half + Eigen::Vector3d::Constant(r)}; }
  /// Returns true if point p_C lies inside or on the box.
  bool contains(const Eigen::Vector3d& p_C) const {
    return ((R_CB.transpose() * (p_C - p_CB)).cwiseAbs().array() <= half.array()).all();
  }
  /// Half of each side length of the smallest axis-aligned box around it [m].
  Eigen::Vector3d reach() const { return R_CB.cwiseAbs() * half; }
  /// Largest value of n·x over the box.
  double support(const Eigen::Vector3d& n) const {
    return n.dot(p_CB) + (R_CB.transpose() * n).cwiseAbs().dot(half);
  }
};

/// Returns the box from corner lo_G to corner hi_G of frame G, expressed in C.
inline OrientedBox box_between(const Eigen::Isometry3d& X_CG, const Eigen::Vector3d& lo_G,
                               const Eigen::Vector3d& hi_G) {
  return {X_CG.linear(), X_CG * Eigen::Vector3d(0.5 * (lo_G + hi_G)), 0.5 * (hi_G - lo_G)};
}

}  // namespace quadrille
