#pragma once

#include <Eigen/Core>
#include <limits>

#include "quadrille/detector/eigen_layout.hpp"

namespace quadrille {

/// The places to which an arm can bring the hand: those between a least and a greatest distance
/// from its base. The origin of the grasp frame G must be such a place at the grasp and at the
/// pre-grasp.
struct Reach {
  /// Position of the base in frame C [m].
  Eigen::Vector3d base_C = Eigen::Vector3d::Zero();
  /// Least and greatest distance of G's origin from the base [m].
  double min = 0.0, max = std::numeric_limits<double>::infinity();

  bool contains(const Eigen::Vector3d& p_C) const {
    const double distance = (p_C - base_C).norm();
    return distance >= min && distance <= max;
  }
};

}  // namespace quadrille
