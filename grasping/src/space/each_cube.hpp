#pragma once

#include <Eigen/Core>

namespace quadrille {

/// Calls visit(low) with the lowest voxel of each cube of a given edge [voxels] that tiles the
/// voxels from `first` up to, and without, `end`, in the order in which grids store them.
template <class Visit>
void each_cube(const Eigen::Vector3i& first, const Eigen::Vector3i& end, int edge, Visit&& visit) {
  for (int k = first.z(); k < end.z(); k += edge) {
    for (int j = first.y(); j < end.y(); j += edge) {
      for (int i = first.x(); i < end.x(); i += edge) visit(Eigen::Vector3i(i, j, k));
    }
  }
}

/// Returns corner n of the cube from −1 to 1 along each axis; bits 0, 1 and 2 of n stand for x, y
/// and z.
inline Eigen::Vector3d cube_corner(unsigned n) {
  return {(n & 1) ? 1.0 : -1.0, (n & 2) ? 1.0 : -1.0, (n & 4) ? 1.0 : -1.0};
}

/// Returns the place of eighth n of a cube whose eighths have edges of 1, in the order of
/// cube_corner().
inline Eigen::Vector3i eighth_of_cube(int n) { return {n & 1, (n >> 1) & 1, n >> 2}; }

}  // namespace quadrille
