// Finds the space beside the image and at missing pixels that lies over seen space.
#include <vector>

#include "space/each_cube.hpp"
#include "space/space_mapper.hpp"
#include "space/upward_steps.hpp"

namespace quadrille {
namespace {

// A block of which the image decides only a part is divided into tiles of this edge, in voxels.
constexpr int kTileEdge = OccupancyGrid::kBlock / 4;

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
struct SpaceMapper::Tile {
  Eigen::Vector3i low;
  int edge;
  bool partly;
};

/// Works layer by layer, as UpwardSteps count them.
OccupancyGrid SpaceMapper::take_cleared(const DepthView& view, const Eigen::Vector3d& up_C) && {
  const UpwardSteps up(up_C, size());
  if (states_.empty() || !up.known()) return std::move(*this).take();
  const int axis = up.axis();
  std::vector<std::vector<Tile>> slices(up.layers() / kTileEdge);
  for (const Tile& tile : tiles_beside(view)) {
    const int first = tile.low[axis] / kTileEdge;
    for (int n = first; n < first + tile.edge / kTileEdge; ++n) slices[n].push_back(tile);
  }
  for (int n = 1; n < up.layers(); ++n) {
    const int layer = up.place(n);
    for (Tile tile : slices[layer / kTileEdge]) {
      tile.low[axis] = layer;
      clear_layer(tile.partly ? &view : nullptr, tile, axis, up.step(n));
    }
  }
  return std::move(*this).take();
}

/// Returns all blocks, or tiles of them, except blocks that the image shows to be entirely free or
/// hidden.
std::vector<SpaceMapper::Tile> SpaceMapper::tiles_beside(const DepthView& view) const {
  std::vector<Tile> tiles;
  each_cube(Eigen::Vector3i::Zero(), grid_.size(), kBlock, [&](const Eigen::Vector3i& block) {
    if (!wanted(block) || !is_beside(view, block)) return;
    const int edge = is_clear(view, block, kBlock) ? kBlock : kTileEdge;
    each_cube(block, block.array() + kBlock, edge, [&](const Eigen::Vector3i& low) {
      tiles.push_back({low, edge, edge < kBlock && !is_clear(view, low, edge)});
    });
  });
  return tiles;
}

bool SpaceMapper::is_beside(const DepthView& view, const Eigen::Vector3i& block) const {
  const Eigen::Vector3d reach = view.reach(0.5 * kBlock * grid_.resolution());
  const Eigen::Vector3d p_V = middle_V(view, block, kBlock);
  const DepthRange range = view.range(p_V, reach);
  const bool free = range.min > p_V.z() + reach.z();
  // A least depth of 0 is that of a missing pixel.
  const bool hidden = range.min != 0.0 && range.max < p_V.z() - reach.z();
  return !free && !hidden;
}

/// Returns true if nothing was measured before or in a cube, so that no voxel in it meets a
/// surface. A pixel is added on all sides, since the pixel nearest to a voxel's centre may lie
/// beside the projection of its edges.
bool SpaceMapper::is_clear(const DepthView& view, const Eigen::Vector3i& low, int edge) const {
  const Eigen::Vector3d p_V = middle_V(view, low, edge);
  const double half = 0.5 * edge * grid_.resolution();
  const double pixel = view.spacing(p_V.z() + view.reach(half).z());
  const Eigen::Vector3d reach = view.reach(half + pixel);
  return view.nearest_surface(p_V, reach) > p_V.z() + reach.z();
}

/// Clears one layer of one tile; `view` is null if nothing was measured there.
void SpaceMapper::clear_layer(const DepthView* view, const Tile& tile, int axis,
                              const Eigen::Vector3i& up) {
  const Eigen::Vector3i &low = tile.low, &size = grid_.size();
  Eigen::Vector3i high = (low.array() + tile.edge).matrix();
  high[axis] = low[axis] + 1;
  const Eigen::Vector3i first = low.cwiseMax(up), last = high.cwiseMin(size + up.cwiseMin(0));
  const std::ptrdiff_t down =
      up.x() + size.x() * (up.y() + static_cast<std::ptrdiff_t>(size.y()) * up.z());
  for (int k = first.z(); k < last.z(); ++k) {
    for (int j = first.y(); j < last.y(); ++j) {
      Voxel* row = &voxel(0, j, k);
      if (!view) {
        clear_row(row + first.x(), row + first.x() - down, last.x() - first.x());
        continue;
      }
      for (int i = first.x(); i < last.x(); ++i) {
        if (!clears(row[i], row[i - down])) continue;
        if (!view->meets_surface(grid_.centre(i, j, k), 0.5 * grid_.resolution())) {
          row[i] = Voxel::kClear;
        }
      }
    }
  }
}

}  // namespace quadrille
