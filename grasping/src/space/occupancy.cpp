#include "quadrille/grasping/occupancy.hpp"

#include <stdexcept>

#include "space/map_limits.hpp"

namespace quadrille {

OccupancyGrid::OccupancyGrid(const Eigen::AlignedBox3d& region, double resolution)
    : resolution_(resolution) {
  if (!(resolution > 0.0)) throw std::invalid_argument("occupancy: resolution must be positive");
  if (region.isEmpty()) return;
  const Eigen::Array3d lo = region.min().array() / resolution / kBlock;
  const Eigen::Array3d hi = region.max().array() / resolution / kBlock;
  if (!((lo.abs() * kBlock < kMaxCoordinate).all() && (hi.abs() * kBlock < kMaxCoordinate).all())) {
    throw std::invalid_argument(
        "occupancy: region lies farther from the origin than 32000 voxels; move the cloud's frame "
        "nearer to it, or set a larger resolution");
  }
  if (count_voxels(region, resolution) > kMaxVoxels) {
    throw std::invalid_argument(
        "occupancy: region has more than 32 million voxels; set a larger resolution");
  }
  corner_ = lo.floor().cast<int>() * kBlock;
  size_ = (hi.floor().cast<int>() + 1) * kBlock - corner_.array();
  states_.assign(size_.cast<std::size_t>().prod(), Voxel::kUnknown);
}

Eigen::AlignedBox3d OccupancyGrid::bounds() const {
  if (states_.empty()) return {};
  const Eigen::Vector3d low = corner_.cast<double>() * resolution_;
  return {low, low + size_.cast<double>() * resolution_};
}

Voxel OccupancyGrid::at(const Eigen::Vector3d& p_C) const {
  const Eigen::Array3d x = (p_C / resolution_).array().floor() - corner_.cast<double>().array();
  if (!((x >= 0.0).all() && (x < size_.cast<double>().array()).all())) return Voxel::kUnknown;
  return at(static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2]));
}

}  // namespace quadrille
