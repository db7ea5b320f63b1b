#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace quadrille {

/// A voxel as one number. Numbers are in the order of the voxels' places: along x first, then along
/// y, then along z.
using VoxelKey = std::int64_t;

/// The voxel in which a point lies, counted from the origin, from which it is less than a million
/// voxels away, as are all points of grids (OccupancyGrid::kMaxCoordinate).
/// @param edge  of the voxels [m]
inline VoxelKey voxel_key(const Eigen::Vector3d& p_C, double edge) {
  // Each axis has so many bits; the shift makes its numbers positive.
  constexpr int kBits = 21;
  constexpr std::int64_t kShift = std::int64_t{1} << (kBits - 1);
  // Unlike std::floor(), this is no function call on plain x86-64.
  const auto whole_below = [](double x) {
    const auto n = static_cast<int>(x);
    return n - static_cast<int>(x < n) + kShift;
  };
  return whole_below(p_C.x() / edge) << (2 * kBits) | whole_below(p_C.y() / edge) << kBits |
         whole_below(p_C.z() / edge);
}

}  // namespace quadrille
