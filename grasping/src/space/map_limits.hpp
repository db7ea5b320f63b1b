#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace quadrille {

/// If needed to fit all targets on one map, the map is made coarser than requested by at most this
/// factor: 20 mm instead of 5 mm, at which the map holds 268 m³.
inline constexpr double kMaxCoarsening = 4.0;

/// Returns the number of voxels in the whole blocks that a region meets.
double count_voxels(const Eigen::AlignedBox3d& region, double resolution);

/// Returns the given resolution, or the next coarser one at which the region has no more than
/// OccupancyGrid::kMaxVoxels.
double fit_resolution(const Eigen::AlignedBox3d& region, double resolution);

/// Returns the indices, in ascending order, of boxes too large or too far away to share one map
/// with the others. The map is filled starting with the boxes nearest to the viewpoint.
std::vector<std::size_t> find_far_boxes(const std::vector<Eigen::AlignedBox3d>& boxes,
                                        const Eigen::Vector3d& viewpoint, double resolution);

}  // namespace quadrille
