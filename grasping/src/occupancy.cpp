#include "quadrille/grasping/occupancy.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace quadrille {

namespace {

constexpr double kRange = 32000.0;

}  // namespace

OccupancyGrid::OccupancyGrid(const PointCloud& cloud, const DepthView& view,
                             const Eigen::AlignedBox3d& region, double resolution)
    : resolution_(resolution) {
  if (!(resolution > 0.0)) throw std::invalid_argument("occupancy: resolution must be positive");
  if (region.isEmpty()) return;
  const Eigen::Array3d lo = region.min().array() / resolution / kBlock;
  const Eigen::Array3d hi = region.max().array() / resolution / kBlock;
  if (!(lo.abs().maxCoeff() * kBlock < kRange && hi.abs().maxCoeff() * kBlock < kRange)) {
    throw std::invalid_argument(
        "occupancy: region leaves the map's range; use a coarser resolution");
  }
  corner_ = lo.floor().cast<int>() * kBlock;
  size_ = (hi.floor().cast<int>() + 1) * kBlock - corner_.array();
  states_.assign(size_.cast<std::size_t>().prod(), Voxel::kUnknown);
  if (view.valid()) mark_free(view);
  mark_occupied(cloud, view);
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

void OccupancyGrid::mark_free(const DepthView& view) {
  for (int k = 0; k < size_.z(); k += kBlock) {
    for (int j = 0; j < size_.y(); j += kBlock) {
      for (int i = 0; i < size_.x(); i += kBlock) mark_free(view, {i, j, k}, kBlock);
    }
  }
}

// Top-down: a block of which the image tells at once that it is free or hidden is not divided.
void OccupancyGrid::mark_free(const DepthView& view, const Eigen::Vector3i& low, int edge) {
  const double half = 0.5 * edge * resolution_;
  const Eigen::Vector3d centre_C =
      ((corner_ + low).cast<double>().array() + 0.5 * edge) * resolution_;
  const Eigen::Vector3d p_V = view.to_view(centre_C);
  const Eigen::Vector3d reach = view.reach(half);
  const DepthRange range = view.range(p_V, reach);
  if (p_V.z() - reach.z() > range.far) return;
  if (p_V.z() + reach.z() < range.near) return fill(low, edge, Voxel::kFree);
  if (edge == 1) {
    if (view.sees_past(centre_C, half)) states_[index(low.x(), low.y(), low.z())] = Voxel::kFree;
    return;
  }
  const int step = edge / 2;
  for (int n = 0; n < 8; ++n) {
    mark_free(view, low + step * Eigen::Vector3i(n & 1, (n >> 1) & 1, n >> 2), step);
  }
}

void OccupancyGrid::mark_occupied(const PointCloud& cloud, const DepthView& view) {
  const std::vector<std::uint8_t>& stray = view.stray();
  const Eigen::Array3f size = size_.cast<float>(), corner = corner_.cast<float>();
  const float scale = static_cast<float>(1.0 / resolution_);
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const Eigen::Array3f x = (cloud.points[n].array() * scale).floor() - corner;
    if (!((x >= 0.0F).all() && (x < size).all()) || stray[n]) continue;
    states_[index(static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2]))] =
        Voxel::kOccupied;
  }
}

void OccupancyGrid::fill(const Eigen::Vector3i& low, int edge, Voxel state) {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      std::fill_n(states_.begin() + static_cast<std::ptrdiff_t>(index(low.x(), j, k)), edge, state);
    }
  }
}

}  // namespace quadrille
