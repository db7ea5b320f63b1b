#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace quadrille {

/// How much coarser than asked for space is mapped at most, so that all targets lie on one map: at
/// 20 mm for 5, whose map then holds 268 m³.
inline constexpr double kMaxCoarsening = 4.0;

/// The voxels of the whole blocks that a region meets.
double count_voxels(const Eigen::AlignedBox3d& region, double resolution);

/// The resolution, or the next coarser one at which a region has no more than
/// OccupancyGrid::kMaxVoxels.
double fit_resolution(const Eigen::AlignedBox3d& region, double resolution);

/// Those of some boxes that have no place on one map with the others, for their size or distance:
/// the map is filled from the viewpoint on. In ascending order.
std::vector<std::size_t> find_far_boxes(const std::vector<Eigen::AlignedBox3d>& boxes,
                                        const Eigen::Vector3d& viewpoint, double resolution);

}  // namespace quadrille
