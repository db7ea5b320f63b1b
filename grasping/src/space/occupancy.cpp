#include "quadrille/grasping/occupancy.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "space/map_limits.hpp"
#include "view/depth_view.hpp"

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

OccupancyGrid::OccupancyGrid(const PointCloud& cloud, const DepthView& view,
                             const Eigen::AlignedBox3d& region, double resolution)
    : OccupancyGrid(region, resolution) {
  add(cloud, view);
}

void OccupancyGrid::add(const PointCloud& cloud, const DepthView& view) {
  if (view.stray().size() != cloud.points.size()) {
    throw std::invalid_argument("occupancy: the view is not that of the cloud");
  }
  // Occupied voxels are marked first, so that they need not be tested for being free.
  mark_occupied(cloud, view.stray());
  if (view.valid()) mark_free(view);
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
      for (int i = 0; i < size_.x(); i += kBlock) {
        if (wanted({i, j, k})) mark_free(view, {i, j, k}, kBlock);
      }
    }
  }
}

bool OccupancyGrid::wanted(const Eigen::Vector3i& block) const {
  const Eigen::Vector3d low = (corner_ + block).cast<double>() * resolution_;
  const Eigen::AlignedBox3d box(low, low + Eigen::Vector3d::Constant(kBlock * resolution_));
  return boxes_C_.empty() ||
         std::any_of(boxes_C_.begin(), boxes_C_.end(),
                     [&](const Eigen::AlignedBox3d& wanted) { return wanted.intersects(box); });
}

/// Works top-down: a block that the image shows at once to be free or hidden is not divided.
void OccupancyGrid::mark_free(const DepthView& view, const Eigen::Vector3i& low, int edge) {
  const double half = 0.5 * edge * resolution_;
  const Eigen::Vector3d centre_C =
      ((corner_ + low).cast<double>().array() + 0.5 * edge) * resolution_;
  const Eigen::Vector3d p_V = view.to_view(centre_C);
  const Eigen::Vector3d reach = view.reach(half);
  const DepthRange range = view.range(p_V, reach);
  if (p_V.z() - reach.z() > range.max) return;
  if (p_V.z() + reach.z() < range.min) return fill_free(low, edge);
  if (edge == 2) return mark_eight(view, low, p_V);
  const int step = edge / 2;
  for (int n = 0; n < 8; ++n) {
    mark_free(view, low + step * Eigen::Vector3i(n & 1, (n >> 1) & 1, n >> 2), step);
  }
}

/// Marks the eight voxels around the point p_V of the view.
void OccupancyGrid::mark_eight(const DepthView& view, const Eigen::Vector3i& low,
                               const Eigen::Vector3d& p_V) {
  // rounding error of floats, in metres at a few metres of depth
  constexpr double kRounding = 1e-6;
  const double half = 0.5 * resolution_;
  const Eigen::Matrix3d axes_V = view.axes() * half;
  DepthView::EightPoints eight;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d at_V =
        p_V + axes_V * Eigen::Vector3d((n & 1) ? 1 : -1, (n & 2) ? 1 : -1, (n & 4) ? 1 : -1);
    eight.row(n) = at_V.cast<float>().transpose().array();
  }
  const Eigen::Vector3d reach = view.reach(half);
  const std::array<DepthRange, 8> ranges = view.ranges(eight, reach);
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3i at = low + Eigen::Vector3i(n & 1, (n >> 1) & 1, n >> 2);
    Voxel& state = states_[index(at.x(), at.y(), at.z())];
    const double z = eight(n, 2), slack = reach.z() + kRounding * (1.0 + z);
    if (state >= Voxel::kFree || z - slack > ranges[n].max) continue;
    if (z + slack < ranges[n].min || view.sees_past(centre(at.x(), at.y(), at.z()), half)) {
      state = Voxel::kFree;
    }
  }
}

void OccupancyGrid::mark_occupied(const PointCloud& cloud, const std::vector<std::uint8_t>& stray) {
  const Eigen::Array3f size = size_.cast<float>(), corner = corner_.cast<float>();
  const float scale = static_cast<float>(1.0 / resolution_);
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const Eigen::Array3f x = (cloud.points[n].array() * scale).floor() - corner;
    if (!((x >= 0.0f).all() && (x < size).all()) || stray[n]) continue;
    states_[index(static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2]))] =
        Voxel::kOccupied;
  }
}

/// Marks the voxels as free, except those that another view found occupied.
void OccupancyGrid::fill_free(const Eigen::Vector3i& low, int edge) {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      Voxel* row = &states_[index(low.x(), j, k)];
      for (int i = 0; i < edge; ++i) row[i] = std::max(row[i], Voxel::kFree);
    }
  }
}

}  // namespace quadrille
