#include <cmath>

#include "quadrille/grasping/occupancy.hpp"

namespace quadrille {

// What the image tells of a whole block.
enum class OccupancyGrid::Sight { kTold, kPartly, kNothing };

// Layer by layer along the axis nearest to up_C. Each voxel stands on the one below it on a
// straight line along up_C, whose steps to the side are rounded as a whole: their errors do not add
// up.
void OccupancyGrid::clear_above(const DepthView& view, const Eigen::Vector3d& up_C) {
  int axis = 0;
  if (states_.empty() || !(up_C.cwiseAbs().maxCoeff(&axis) > 0.5)) return;
  std::vector<std::pair<Eigen::Vector3i, Sight>> blocks;
  for (int k = 0; k < size_.z(); k += kBlock) {
    for (int j = 0; j < size_.y(); j += kBlock) {
      for (int i = 0; i < size_.x(); i += kBlock) {
        const Sight seen = wanted({i, j, k}) ? sight(view, {i, j, k}) : Sight::kTold;
        if (seen != Sight::kTold) blocks.push_back({{i, j, k}, seen});
      }
    }
  }
  const Eigen::Vector3d slope = up_C / std::abs(up_C[axis]);
  const auto shift = [&](int n) -> Eigen::Vector3i {
    return (n * slope).array().round().cast<int>().matrix();
  };
  for (int n = 1; n < size_[axis]; ++n) {
    const int layer = up_C[axis] > 0.0 ? n : size_[axis] - 1 - n;
    for (auto [low, seen] : blocks) {
      if (low[axis] / kBlock != layer / kBlock) continue;
      low[axis] = layer;
      const DepthView* asked = seen == Sight::kPartly ? &view : nullptr;
      clear_tile(asked, low, axis, shift(n) - shift(n - 1));
    }
  }
}

OccupancyGrid::Sight OccupancyGrid::sight(const DepthView& view,
                                          const Eigen::Vector3i& block) const {
  const double half = 0.5 * kBlock * resolution_;
  const Eigen::Vector3d low_C = (corner_ + block).cast<double>() * resolution_;
  const Eigen::Vector3d p_V = view.to_view(low_C.array() + half), reach = view.reach(half);
  const DepthRange range = view.range(p_V, reach);
  if (range.far == 0.0) return Sight::kNothing;
  const bool free = range.near > p_V.z() + reach.z();
  const bool hidden = range.near > 0.0 && range.far < p_V.z() - reach.z();
  return free || hidden ? Sight::kTold : Sight::kPartly;
}

// One layer of one block; no view: nothing was measured there.
void OccupancyGrid::clear_tile(const DepthView* view, const Eigen::Vector3i& low, int axis,
                               const Eigen::Vector3i& up) {
  Eigen::Vector3i high = (low.array() + kBlock).matrix();
  high[axis] = low[axis] + 1;
  const Eigen::Vector3i first = low.cwiseMax(up), last = high.cwiseMin(size_ + up.cwiseMin(0));
  const std::ptrdiff_t down =
      up.x() + size_.x() * (up.y() + static_cast<std::ptrdiff_t>(size_.y()) * up.z());
  for (int k = first.z(); k < last.z(); ++k) {
    for (int j = first.y(); j < last.y(); ++j) {
      Voxel* row = &states_[index(0, j, k)];
      for (int i = first.x(); i < last.x(); ++i) {
        const Voxel below = row[i - down];
        if (row[i] != Voxel::kUnknown) continue;
        if (below != Voxel::kFree && below != Voxel::kClear) continue;
        if (view && view->meets_surface(centre(i, j, k), 0.5 * resolution_)) continue;
        row[i] = Voxel::kClear;
      }
    }
  }
}

}  // namespace quadrille
