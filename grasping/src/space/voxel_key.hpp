#pragma once

#include <Eigen/Core>
#include <array>

namespace quadrille {

/// Number of a voxel along x, y and z, which can be sorted.
using VoxelKey = std::array<int, 3>;

/// The voxel in which a point lies, counted from the origin.
/// @param edge  of the voxels [m]
inline VoxelKey voxel_key(const Eigen::Vector3d& p_C, double edge) {
  const Eigen::Vector3i key = (p_C / edge).array().floor().cast<int>();
  return {key.x(), key.y(), key.z()};
}

}  // namespace quadrille
