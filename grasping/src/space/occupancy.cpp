#include "quadrille/grasping/occupancy.hpp"

#include <stdexcept>

#include "space/map_limits.hpp"
#include "space/space_on_demand.hpp"

namespace quadrille {

OccupancyGrid::OccupancyGrid(const Eigen::AlignedBox3d& region, double resolution)
    : OccupancyGrid(without_states(region, resolution)) {
  states_.assign(size_.cast<std::size_t>().prod(), Voxel::kUnknown);
}

OccupancyGrid OccupancyGrid::without_states(const Eigen::AlignedBox3d& region, double resolution) {
  OccupancyGrid grid;
  grid.resolution_ = resolution;
  if (!(resolution > 0.0)) throw std::invalid_argument("occupancy: resolution must be positive");
  if (region.isEmpty()) return grid;
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
  grid.corner_ = lo.floor().cast<int>() * kBlock;
  grid.size_ = (hi.floor().cast<int>() + 1) * kBlock - grid.corner_.array();
  return grid;
}

Eigen::AlignedBox3d OccupancyGrid::bounds() const {
  if (size_.isZero()) return {};
  const Eigen::Vector3d low = corner_.cast<double>() * resolution_;
  return {low, low + size_.cast<double>() * resolution_};
}

Voxel OccupancyGrid::at(const Eigen::Vector3d& p_C) const {
  const Eigen::Array3d x = (p_C / resolution_).array().floor() - corner_.cast<double>().array();
  if (!((x >= 0.0).all() && (x < size_.cast<double>().array()).all())) return Voxel::kUnknown;
  const Eigen::Vector3i voxel = x.cast<int>();
  return source_ ? source_->at(voxel) : states_[index(voxel.x(), voxel.y(), voxel.z())];
}

const std::vector<Voxel>& OccupancyGrid::all_of_source() const { return source_->all(); }

}  // namespace quadrille
