#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace quadrille {

/// Calls visit(p) for the middles of the voxels in a cube of a map that may lie in a voxel of
/// another lattice with its middle outside of the cube.
/// @param region  only those in or beside it count
/// @param edge, other  edges of the voxels of both lattices [m]
template <class Visit>
void each_outer_middle(const Eigen::AlignedBox3d& cube, const Eigen::AlignedBox3d& region,
                       double edge, double other, Visit&& visit) {
  const Eigen::Array3d last = (cube.sizes().array() / edge).round().max(1.0) - 1.0;
  const Eigen::Array3d low = ((region.min() - cube.min()).array() / edge).floor().max(0.0);
  const Eigen::Array3d high = ((region.max() - cube.min()).array() / edge).floor().min(last);
  const double layers = std::ceil(0.5 * std::sqrt(3.0) * other / edge) + 1.0;
  if ((low > high).any()) return;
  const auto is_outer = [&](double n, int axis) { return n < layers || n > last[axis] - layers; };
  for (double k = low.z(); k <= high.z(); ++k) {
    for (double j = low.y(); j <= high.y(); ++j) {
      const bool all = is_outer(k, 2) || is_outer(j, 1);
      for (double i = low.x(); i <= high.x(); ++i) {
        // The inner voxels of a row are passed over in one step.
        if (!all && !is_outer(i, 0)) i = std::max(i, last.x() - layers + 1.0);
        if (i > high.x()) break;
        visit(Eigen::Vector3d(cube.min().array() + edge * (Eigen::Array3d(i, j, k) + 0.5)));
      }
    }
  }
}

}  // namespace quadrille
