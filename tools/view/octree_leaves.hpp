#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "view/voxel_layers.hpp"

namespace quadrille::view {

/// The space that an octree covers, out of OctoMap's binary stream (the content of a .bt file), as
/// a block of voxels. Never reads past the end, and holds no more than kMaxBlockVoxels: larger
/// space comes in larger voxels.
/// @return nullopt if that is no octree, is cut short, or holds no leaf
std::optional<VoxelBlock> read_octree(std::span<const std::uint8_t> stream, double resolution);

inline constexpr double kMaxBlockVoxels = 4 << 20;

}  // namespace quadrille::view
