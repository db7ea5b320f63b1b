#include <octomap/OcTree.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "quadrille/grasping/occupancy.hpp"
#include "space/each_cube.hpp"

namespace quadrille {
namespace {

/// OctoMap's own tree gets a root only together with its first voxel; this one has a root from the
/// start.
class RootedTree : public octomap::OcTree {
 public:
  explicit RootedTree(double resolution) : octomap::OcTree(resolution) {
    root = new octomap::OcTreeNode();
    tree_size = 1;
    size_changed = true;
  }
};

/// The states of a grid for the octree, which has no clear voxels.
std::vector<Voxel> seen_states(const OccupancyGrid& grid) {
  std::vector<Voxel> states = grid.states();
  std::replace(states.begin(), states.end(), Voxel::kClear, Voxel::kUnknown);
  return states;
}

/// Returns true if some voxels side by side, 1, 2 or a multiple of 4, have one state.
bool are_all(Voxel state, const Voxel* row, int count) {
  if (count < 4) return std::count(row, row + count, state) == count;
  constexpr std::uint32_t kEachByte = 0x01010101;
  std::uint32_t differs = 0;
  // Four voxels at once.
  for (int i = 0; i < count; i += 4) {
    std::uint32_t four = 0;
    std::memcpy(&four, row + i, sizeof(four));
    differs |= four ^ (static_cast<std::uint32_t>(state) * kEachByte);
  }
  return differs == 0;
}
static_assert(sizeof(Voxel) == 1);

/// Writes one grid into a tree, block by block, because OctoMap's own ray insertion takes seconds.
class TreeWriter {
 public:
  explicit TreeWriter(const OccupancyGrid& grid)
      : grid_(grid),
        states_(seen_states(grid)),
        tree_(std::make_shared<octomap::OcTree>(grid.resolution())) {}

  std::shared_ptr<octomap::OcTree> write() {
    each_cube(Eigen::Vector3i::Zero(), grid_.size(), OccupancyGrid::kBlock,
              [&](const Eigen::Vector3i& low) { write_block(low); });
    // Without this call FCL takes occupied cells for free, because inner nodes do not know their
    // children yet.
    if (tree_->getRoot()) tree_->updateInnerOccupancy();
    return tree_;
  }

 private:
  /// Returns the state that all voxels of the cube share, or −1.
  int uniform(const Eigen::Vector3i& low, int edge) const {
    const Voxel first = states_.data()[grid_.index(low.x(), low.y(), low.z())];
    for (int k = low.z(); k < low.z() + edge; ++k) {
      for (int j = low.y(); j < low.y() + edge; ++j) {
        if (!are_all(first, states_.data() + grid_.index(low.x(), j, k), edge)) return -1;
      }
    }
    return static_cast<int>(first);
  }

  static bool absent(int state) { return state == static_cast<int>(Voxel::kUnknown); }

  void write_block(const Eigen::Vector3i& low) {
    const int state = uniform(low, OccupancyGrid::kBlock);
    if (absent(state)) return;
    if (!tree_->getRoot()) tree_ = std::make_shared<RootedTree>(grid_.resolution());
    octomap::OcTreeNode* node = tree_->getRoot();
    const Eigen::Vector3i key = grid_.corner() + low + Eigen::Vector3i::Constant(32768);
    for (int edge = 1 << 15; edge >= OccupancyGrid::kBlock; edge /= 2) {
      node = child(node, key, edge);
    }
    write_node(node, low, OccupancyGrid::kBlock, state);
  }

  /// Returns the child of a node that holds the voxel of this key, made if it is missing.
  /// @param edge  edge of the child, a power of two [voxels]
  octomap::OcTreeNode* child(octomap::OcTreeNode* node, const Eigen::Vector3i& key, int edge) {
    const unsigned n =
        (key.x() & edge ? 1u : 0u) | (key.y() & edge ? 2u : 0u) | (key.z() & edge ? 4u : 0u);
    return tree_->nodeChildExists(node, n) ? tree_->getNodeChild(node, n)
                                           : tree_->createNodeChild(node, n);
  }

  void write_node(octomap::OcTreeNode* node, const Eigen::Vector3i& low, int edge, int state) {
    if (state >= 0) {
      const bool free = state == static_cast<int>(Voxel::kFree);
      node->setLogOdds(free ? tree_->getClampingThresMinLog() : tree_->getClampingThresMaxLog());
      return;
    }
    const int step = edge / 2;
    for (int n = 0; n < 8; ++n) {
      const Eigen::Vector3i at = low + step * eighth_of_cube(n);
      const int part = uniform(at, step);
      if (!absent(part))
        write_node(tree_->createNodeChild(node, static_cast<unsigned>(n)), at, step, part);
    }
  }

  const OccupancyGrid& grid_;
  const std::vector<Voxel> states_;
  std::shared_ptr<octomap::OcTree> tree_;
};

}  // namespace

std::shared_ptr<octomap::OcTree> OccupancyGrid::to_octree() const {
  return TreeWriter(*this).write();
}

}  // namespace quadrille
