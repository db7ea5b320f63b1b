#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"

namespace quadrille::view {

/// The voxels of a map that are shown: those at the borders of occupied or unknown space.
struct VoxelLayers {
  /// Edge of a voxel, and the corner of voxel (0, 0, 0) [m].
  double edge = 0.0;
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  std::vector<std::array<std::uint16_t, 3>> occupied, unknown;
};

/// A block of voxels; x varies fastest.
struct VoxelBlock {
  double edge = 0.0;
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<Voxel> states;

  Voxel& at(int i, int j, int k) { return states[index(i, j, k)]; }
  Voxel at(int i, int j, int k) const { return states[index(i, j, k)]; }

 private:
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * size.y() + j) * size.x() + i;
  }
};

/// Returns the layers of a block. The voxels are doubled in size until no layer has more than
/// `max_voxels`.
VoxelLayers layers_of(VoxelBlock block, std::size_t max_voxels);

/// Returns the layers of a plan's map of space.
VoxelLayers layers_of(const OccupancyGrid& space, std::size_t max_voxels);

}  // namespace quadrille::view
