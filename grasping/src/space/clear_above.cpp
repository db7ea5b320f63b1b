#include <algorithm>
#include <cmath>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"
#include "view/depth_view.hpp"

namespace quadrille {
namespace {

// A block of which the image decides only a part is divided into tiles of this edge, in voxels.
constexpr int kTileEdge = 4;

/// Returns true if nothing was measured before or in a cube, so that no voxel in it meets a
/// surface. A pixel is added on all sides, since the pixel nearest to a voxel's centre may lie
/// beside the projection of its edges.
bool clear(const DepthView& view, const Eigen::Vector3d& p_V, double half) {
  const double pixel = view.spacing(p_V.z() + view.reach(half).z());
  const Eigen::Vector3d reach = view.reach(half + pixel);
  return view.nearest_surface(p_V, reach) > p_V.z() + reach.z();
}

/// Returns true if a voxel becomes clear because the voxel below it is free or clear.
bool clears(Voxel state, Voxel below) {
  return (state == Voxel::kUnknown) & ((below == Voxel::kFree) | (below == Voxel::kClear));
}

void clear_row(Voxel* row, const Voxel* below, int count) {
  for (int i = 0; i < count; ++i) row[i] = clears(row[i], below[i]) ? Voxel::kClear : row[i];
}

}  // namespace

/// A cube of voxels. If `partly` is set, its voxels have to be checked against the image one by
/// one.
struct OccupancyGrid::Tile {
  Eigen::Vector3i low;
  int edge;
  bool partly;
};

/// Works layer by layer along the axis nearest to up_C. Each voxel stands on the one below it on a
/// straight line along up_C. The sideways shift is rounded as a whole, so that rounding errors do
/// not add up.
void OccupancyGrid::clear_above(const DepthView& view, const Eigen::Vector3d& up_C) {
  int axis = 0;
  if (states_.empty() || !(up_C.cwiseAbs().maxCoeff(&axis) > 0.5)) return;
  std::vector<std::vector<Tile>> slices(size_[axis] / kTileEdge);
  for (const Tile& tile : tiles_beside(view)) {
    const int first = tile.low[axis] / kTileEdge;
    for (int n = first; n < first + tile.edge / kTileEdge; ++n) slices[n].push_back(tile);
  }
  const Eigen::Vector3d slope = up_C / std::abs(up_C[axis]);
  const auto shift = [&](int n) -> Eigen::Vector3i {
    return (n * slope).array().round().cast<int>().matrix();
  };
  for (int n = 1; n < size_[axis]; ++n) {
    const int layer = up_C[axis] > 0.0 ? n : size_[axis] - 1 - n;
    for (Tile tile : slices[layer / kTileEdge]) {
      tile.low[axis] = layer;
      clear_layer(tile.partly ? &view : nullptr, tile, axis, shift(n) - shift(n - 1));
    }
  }
}

/// Returns all blocks except those that the image shows to be entirely free or hidden.
std::vector<OccupancyGrid::Tile> OccupancyGrid::tiles_beside(const DepthView& view) const {
  const double half = 0.5 * kBlock * resolution_;
  const Eigen::Vector3d reach = view.reach(half);
  std::vector<Tile> tiles;
  for (int k = 0; k < size_.z(); k += kBlock) {
    for (int j = 0; j < size_.y(); j += kBlock) {
      for (int i = 0; i < size_.x(); i += kBlock) {
        const Eigen::Vector3i low(i, j, k);
        if (!wanted(low)) continue;
        const Eigen::Vector3d p_V =
            view.to_view((((corner_ + low).cast<double>() * resolution_).array() + half).matrix());
        const DepthRange range = view.range(p_V, reach);
        const bool free = range.min > p_V.z() + reach.z();
        const bool hidden = range.min > 0.0 && range.max < p_V.z() - reach.z();
        if (free || hidden) continue;
        if (clear(view, p_V, half)) {
          tiles.push_back({low, kBlock, false});
        } else {
          divide(view, low, tiles);
        }
      }
    }
  }
  return tiles;
}

void OccupancyGrid::divide(const DepthView& view, const Eigen::Vector3i& block,
                           std::vector<Tile>& tiles) const {
  const double half = 0.5 * kTileEdge * resolution_;
  for (int k = 0; k < kBlock; k += kTileEdge) {
    for (int j = 0; j < kBlock; j += kTileEdge) {
      for (int i = 0; i < kBlock; i += kTileEdge) {
        const Eigen::Vector3i low = block + Eigen::Vector3i(i, j, k);
        const Eigen::Vector3d p_V =
            view.to_view((((corner_ + low).cast<double>() * resolution_).array() + half).matrix());
        tiles.push_back({low, kTileEdge, !clear(view, p_V, half)});
      }
    }
  }
}

/// Clears one layer of one tile; `view` is null if nothing was measured there.
void OccupancyGrid::clear_layer(const DepthView* view, const Tile& tile, int axis,
                                const Eigen::Vector3i& up) {
  const Eigen::Vector3i& low = tile.low;
  Eigen::Vector3i high = (low.array() + tile.edge).matrix();
  high[axis] = low[axis] + 1;
  const Eigen::Vector3i first = low.cwiseMax(up), last = high.cwiseMin(size_ + up.cwiseMin(0));
  const std::ptrdiff_t down =
      up.x() + size_.x() * (up.y() + static_cast<std::ptrdiff_t>(size_.y()) * up.z());
  for (int k = first.z(); k < last.z(); ++k) {
    for (int j = first.y(); j < last.y(); ++j) {
      Voxel* row = &states_[index(0, j, k)];
      if (!view) {
        clear_row(row + first.x(), row + first.x() - down, last.x() - first.x());
        continue;
      }
      for (int i = first.x(); i < last.x(); ++i) {
        if (!clears(row[i], row[i - down])) continue;
        if (!view->meets_surface(centre(i, j, k), 0.5 * resolution_)) row[i] = Voxel::kClear;
      }
    }
  }
}

}  // namespace quadrille
