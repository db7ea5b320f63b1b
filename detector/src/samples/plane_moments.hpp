#pragma once

#include <Eigen/Core>

namespace quadrille {

/// Sums over offsets from a point near them, for a plane by principal components. In single
/// precision and solved in a closed form, for there is one for each sample; PlaneSums is for whole
/// regions.
struct PlaneMoments {
  float n = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  /// Sums of xx, yy, zz and of xy, yz, zx.
  Eigen::Array3f squares = Eigen::Array3f::Zero(), products = Eigen::Array3f::Zero();

  void add(const Eigen::Vector3f& d) {
    n += 1;
    sum += d;
    squares += d.array().square();
    products += d.array() * Eigen::Array3f(d.y(), d.z(), d.x());
  }
  /// Mean of the offsets, from the point that they are taken from, and the unit direction in which
  /// they are spread least.
  /// @return false if they are few, lie on a line, or spread alike in all directions
  bool solve(Eigen::Vector3f* mean, Eigen::Vector3f* normal) const;
};

}  // namespace quadrille
