#include "view/scene/voxel_layers.hpp"

#include <algorithm>

namespace quadrille::view {
namespace {

/// Returns the state of a voxel that contains two others: occupied takes precedence, then unknown.
Voxel joined(Voxel a, Voxel b) {
  const auto rank = [](Voxel v) {
    return v == Voxel::kOccupied ? 2 : v == Voxel::kUnknown ? 1 : 0;
  };
  return rank(a) >= rank(b) ? a : b;
}

VoxelBlock halved(const VoxelBlock& fine) {
  VoxelBlock coarse{2.0 * fine.edge, fine.corner, (fine.size.array() + 1) / 2, {}};
  coarse.states.assign(static_cast<std::size_t>(coarse.size.prod()), Voxel::kFree);
  for (int k = 0; k < fine.size.z(); ++k) {
    for (int j = 0; j < fine.size.y(); ++j) {
      for (int i = 0; i < fine.size.x(); ++i) {
        const auto at =
            (static_cast<std::size_t>(k / 2) * coarse.size.y() + j / 2) * coarse.size.x() + i / 2;
        coarse.states[at] = joined(coarse.states[at], fine.at(i, j, k));
      }
    }
  }
  return coarse;
}

/// Returns true if space that the hand may use begins beside a voxel; other voxels are hidden by
/// their neighbours.
bool is_border(const VoxelBlock& block, int i, int j, int k) {
  constexpr std::array<std::array<int, 3>, 6> kSteps = {
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  for (const auto& [x, y, z] : kSteps) {
    const Eigen::Array3i n(i + x, j + y, k + z);
    if ((n < 0).any() || (n >= block.size.array()).any()) continue;
    const Voxel beside = block.at(n.x(), n.y(), n.z());
    if (beside == Voxel::kFree || beside == Voxel::kClear) return true;
  }
  return false;
}

VoxelLayers borders_of(const VoxelBlock& block) {
  VoxelLayers layers;
  layers.edge = block.edge;
  layers.corner = block.corner;
  for (int k = 0; k < block.size.z(); ++k) {
    for (int j = 0; j < block.size.y(); ++j) {
      for (int i = 0; i < block.size.x(); ++i) {
        const Voxel state = block.at(i, j, k);
        if (state != Voxel::kOccupied && state != Voxel::kUnknown) continue;
        if (!is_border(block, i, j, k)) continue;
        auto& layer = state == Voxel::kOccupied ? layers.occupied : layers.unknown;
        layer.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                         static_cast<std::uint16_t>(k)});
      }
    }
  }
  return layers;
}

}  // namespace

VoxelLayers layers_of(VoxelBlock block, std::size_t max_voxels) {
  VoxelLayers layers = borders_of(block);
  while (std::max(layers.occupied.size(), layers.unknown.size()) > max_voxels) {
    block = halved(block);
    layers = borders_of(block);
  }
  return layers;
}

VoxelLayers layers_of(const OccupancyGrid& space, std::size_t max_voxels) {
  return layers_of(
      VoxelBlock{space.resolution(), space.corner().cast<double>() * space.resolution(),
                 space.size(), space.states()},
      max_voxels);
}

}  // namespace quadrille::view
