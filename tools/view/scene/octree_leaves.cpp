#include "view/scene/octree_leaves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string_view>

namespace quadrille::view {
namespace {

/// Number of levels of OctoMap's trees, and the index of the voxel in the middle.
constexpr int kDepth = 16, kMiddle = 1 << (kDepth - 1);
/// Limit of the number of leaves; the map of a plan has a hundredth of it.
constexpr std::size_t kMaxLeaves = 4 << 20;

struct Leaf {
  Eigen::Vector3i corner;
  int edge = 0;
  bool occupied = false;
};

/// Walks over the nodes. A node has two bits for each of its eight children; the lowest bit of a
/// child's number stands for x.
class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool run(const Eigen::Vector3i& corner, int edge) {
    if (bytes_.size() - at_ < 2 || edge < 2) return false;
    const unsigned children = bytes_[at_] | unsigned{bytes_[at_ + 1]} << 8;
    at_ += 2;
    for (int i = 0; i < 8; ++i) {
      const unsigned kind = children >> (2 * i) & 3u;
      const Eigen::Vector3i low = corner + edge / 2 * Eigen::Vector3i(i & 1, i >> 1 & 1, i >> 2);
      // The children of an inner child follow at once, before those of its next sibling.
      if (kind == kInner && !run(low, edge / 2)) return false;
      if (kind != kFree && kind != kOccupied) continue;
      if (leaves.size() == kMaxLeaves) return false;
      leaves.push_back({low, edge / 2, kind == kOccupied});
    }
    return true;
  }

  std::vector<Leaf> leaves;

 private:
  static constexpr unsigned kFree = 1, kOccupied = 2, kInner = 3;
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// Returns the bytes after the header; empty if there is no valid header.
std::span<const std::uint8_t> body_of(std::span<const std::uint8_t> stream) {
  constexpr std::string_view kMark = "\ndata\n";
  const std::string_view text(reinterpret_cast<const char*>(stream.data()), stream.size());
  const std::size_t at = text.substr(0, 512).find(kMark);
  if (!text.starts_with("# Octomap OcTree") || at == std::string_view::npos) return {};
  return stream.subspan(at + kMark.size());
}

VoxelBlock block_of(const std::vector<Leaf>& leaves, double resolution) {
  Eigen::AlignedBox3i box;
  for (const Leaf& leaf : leaves) {
    box.extend(leaf.corner);
    box.extend((leaf.corner.array() + leaf.edge).matrix().eval());
  }
  int scale = 1;
  const auto size_at = [&](int s) -> Eigen::Vector3i {
    return (box.sizes().array() + s - 1) / s + 1;
  };
  while (size_at(scale).cast<double>().prod() > kMaxBlockVoxels) scale *= 2;
  VoxelBlock block;
  block.edge = scale * resolution;
  block.size = size_at(scale);
  block.corner = (box.min().array() - kMiddle).cast<double>() * resolution;
  block.states.assign(static_cast<std::size_t>(block.size.prod()), Voxel::kUnknown);
  for (const bool occupied : {false, true}) {
    for (const Leaf& leaf : leaves) {
      if (leaf.occupied != occupied) continue;
      const Eigen::Vector3i low = (leaf.corner - box.min()) / scale;
      const Eigen::Vector3i high =
          (leaf.corner - box.min()).array() / scale + std::max(leaf.edge / scale, 1);
      for (int k = low.z(); k < high.z(); ++k) {
        for (int j = low.y(); j < high.y(); ++j) {
          for (int i = low.x(); i < high.x(); ++i)
            block.at(i, j, k) = occupied ? Voxel::kOccupied : Voxel::kFree;
        }
      }
    }
  }
  return block;
}

}  // namespace

std::optional<VoxelBlock> read_octree(std::span<const std::uint8_t> stream, double resolution) {
  Walk walk(body_of(stream));
  if (!walk.run(Eigen::Vector3i::Zero(), 1 << kDepth) || walk.leaves.empty()) return std::nullopt;
  return block_of(walk.leaves, resolution);
}

}  // namespace quadrille::view
