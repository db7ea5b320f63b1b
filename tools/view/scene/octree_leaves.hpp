#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "view/scene/voxel_layers.hpp"

namespace quadrille::view {

/// Reads the space that an octree covers from OctoMap's binary stream (the content of a .bt file),
/// as a block of voxels. It never reads past the end. The block has at most kMaxBlockVoxels; a
/// larger space gets larger voxels.
/// @return nullopt if the stream is no octree, is truncated, or holds no leaf
std::optional<VoxelBlock> read_octree(std::span<const std::uint8_t> stream, double resolution);

inline constexpr double kMaxBlockVoxels = 4 << 20;

}  // namespace quadrille::view
