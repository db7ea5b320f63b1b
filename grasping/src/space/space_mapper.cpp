#include "space/space_mapper.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/rounding.hpp"
#include "space/each_cube.hpp"

namespace quadrille {

void SpaceMapper::add(const PointCloud& cloud, const DepthView& view,
                      const std::vector<std::uint8_t>& left_out) {
  if (view.stray().size() != cloud.points.size() || left_out.size() != cloud.points.size()) {
    throw std::invalid_argument("occupancy: the view is not that of the cloud");
  }
  // Occupied voxels are marked first, so that they need not be tested for being free.
  mark_occupied(cloud, left_out);
  if (view.valid()) mark_free(view);
}

bool SpaceMapper::wanted(const Eigen::Vector3i& block) const {
  const double edge = OccupancyGrid::kBlock * grid_.resolution();
  const Eigen::Vector3d low = (grid_.corner() + block).cast<double>() * grid_.resolution();
  const Eigen::AlignedBox3d box(low, low + Eigen::Vector3d::Constant(edge));
  return boxes_C_.empty() ||
         std::any_of(boxes_C_.begin(), boxes_C_.end(),
                     [&](const Eigen::AlignedBox3d& wanted) { return wanted.intersects(box); });
}

/// Returns the middle of a cube of voxels in the frame of the view.
Eigen::Vector3d SpaceMapper::middle_V(const DepthView& view, const Eigen::Vector3i& low,
                                      int edge) const {
  return view.to_view(((grid_.corner() + low).cast<double>().array() + 0.5 * edge) *
                      grid_.resolution());
}

void SpaceMapper::mark_free(const DepthView& view) {
  each_cube(Eigen::Vector3i::Zero(), grid_.size(), OccupancyGrid::kBlock,
            [&](const Eigen::Vector3i& block) {
              if (wanted(block)) mark_free(view, block, OccupancyGrid::kBlock);
            });
}

/// Works top-down: a block that the image shows at once to be free or hidden is not divided.
void SpaceMapper::mark_free(const DepthView& view, const Eigen::Vector3i& low, int edge) {
  if (is_known(low, edge)) return;
  const Eigen::Vector3d p_V = middle_V(view, low, edge);
  const Eigen::Vector3d reach = view.reach(0.5 * edge * grid_.resolution());
  const DepthRange range = view.range(p_V, reach);
  if (p_V.z() - reach.z() > range.max) return;
  if (p_V.z() + reach.z() < range.min) return fill_free(low, edge);
  if (edge == 2) return mark_eight(view, low, p_V);
  const int step = edge / 2;
  for (int n = 0; n < 8; ++n) mark_free(view, low + step * eighth_of_cube(n), step);
}

/// True if each voxel of a cube is free or occupied, as after other views.
bool SpaceMapper::is_known(const Eigen::Vector3i& low, int edge) const {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      const Voxel* row = &grid_.states()[grid_.index(low.x(), j, k)];
      if (*std::min_element(row, row + edge) < Voxel::kFree) return false;
    }
  }
  return true;
}

/// Marks the eight voxels around the point p_V of the view.
void SpaceMapper::mark_eight(const DepthView& view, const Eigen::Vector3i& low,
                             const Eigen::Vector3d& p_V) {
  const double half = 0.5 * grid_.resolution();
  const Eigen::Matrix3d axes_V = view.axes() * half;
  DepthView::EightPoints eight;
  for (unsigned n = 0; n < 8; ++n) {
    eight.row(n) = (p_V + axes_V * cube_corner(n)).cast<float>().transpose().array();
  }
  const Eigen::Vector3d reach = view.reach(half);
  const std::array<DepthRange, 8> ranges = view.ranges(eight, reach);
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3i at = low + eighth_of_cube(n);
    Voxel& state = voxel(at.x(), at.y(), at.z());
    // Depths that are equal to within the rounding of floats are compared exactly, by sees_past().
    const double z = eight(n, 2), slack = reach.z() + kFloatRounding * (1.0 + z);
    if (state >= Voxel::kFree || z - slack > ranges[n].max) continue;
    if (z + slack < ranges[n].min || view.sees_past(grid_.centre(at.x(), at.y(), at.z()), half)) {
      state = Voxel::kFree;
    }
  }
}

void SpaceMapper::mark_occupied(const PointCloud& cloud,
                                const std::vector<std::uint8_t>& left_out) {
  const Eigen::Array3f size = grid_.size().cast<float>(), corner = grid_.corner().cast<float>();
  const float scale = static_cast<float>(1.0 / grid_.resolution());
  for (std::size_t n = 0; n < cloud.points.size(); ++n) {
    const Eigen::Array3f x = (cloud.points[n].array() * scale).floor() - corner;
    if (!((x >= 0.0f).all() && (x < size).all()) || left_out[n]) continue;
    voxel(static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])) =
        Voxel::kOccupied;
  }
}

/// Marks the voxels as free, except those that another view found occupied.
void SpaceMapper::fill_free(const Eigen::Vector3i& low, int edge) {
  for (int k = low.z(); k < low.z() + edge; ++k) {
    for (int j = low.y(); j < low.y() + edge; ++j) {
      Voxel* row = &voxel(low.x(), j, k);
      for (int i = 0; i < edge; ++i) row[i] = std::max(row[i], Voxel::kFree);
    }
  }
}

}  // namespace quadrille
