#include "space/map_limits.hpp"

#include <algorithm>
#include <cmath>

#include "quadrille/grasping/occupancy.hpp"

namespace quadrille {
namespace {

bool fits(const Eigen::AlignedBox3d& region, double resolution) {
  return count_voxels(region, kMaxCoarsening * resolution) <= OccupancyGrid::kMaxVoxels;
}

/// Returns false also for bounds that are not finite.
bool in_range(const Eigen::AlignedBox3d& box, double resolution) {
  const double reach = OccupancyGrid::kMaxCoordinate * resolution;
  return (box.min().array().abs() < reach).all() && (box.max().array().abs() < reach).all();
}

}  // namespace

double count_voxels(const Eigen::AlignedBox3d& region, double resolution) {
  const double edge = OccupancyGrid::kBlock * resolution;
  const Eigen::Array3d blocks = (region.max().array() / edge).floor() + 1.0 -  //
                                (region.min().array() / edge).floor();
  return blocks.prod() * std::pow(OccupancyGrid::kBlock, 3);
}

double fit_resolution(const Eigen::AlignedBox3d& region, double resolution) {
  // A thin region still takes up whole blocks, so a step by the cube root reduces its count too
  // little.
  constexpr double kMinStep = 1.01;
  for (;;) {
    const double excess = count_voxels(region, resolution) / OccupancyGrid::kMaxVoxels;
    if (!(excess > 1.0)) return resolution;
    resolution *= std::max(kMinStep, std::cbrt(excess));
  }
}

std::vector<std::size_t> find_far_boxes(const std::vector<Eigen::AlignedBox3d>& boxes,
                                        const Eigen::Vector3d& viewpoint, double resolution) {
  std::vector<std::size_t> order, far;
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    (in_range(boxes[n], resolution) ? order : far).push_back(n);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].squaredExteriorDistance(viewpoint) <
           boxes[b].squaredExteriorDistance(viewpoint);
  });
  Eigen::AlignedBox3d region;
  for (const std::size_t n : order) {
    const Eigen::AlignedBox3d with = region.merged(boxes[n]);
    if (fits(with, resolution)) {
      region = with;
    } else {
      far.push_back(n);
    }
  }
  std::sort(far.begin(), far.end());
  return far;
}

}  // namespace quadrille
