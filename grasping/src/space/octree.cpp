#include <octomap/OcTree.h>

#include "quadrille/grasping/occupancy.hpp"

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

/// Writes one grid into a tree, block by block, because OctoMap's own ray insertion takes seconds.
class TreeWriter {
 public:
  explicit TreeWriter(const OccupancyGrid& grid)
      : grid_(grid), tree_(std::make_shared<octomap::OcTree>(grid.resolution())) {}

  std::shared_ptr<octomap::OcTree> write() {
    constexpr int kEdge = OccupancyGrid::kBlock;
    for (int k = 0; k < grid_.size().z(); k += kEdge) {
      for (int j = 0; j < grid_.size().y(); j += kEdge) {
        for (int i = 0; i < grid_.size().x(); i += kEdge) write_block({i, j, k});
      }
    }
    // Without this call FCL takes occupied cells for free, because inner nodes do not know their
    // children yet.
    if (tree_->getRoot()) tree_->updateInnerOccupancy();
    return tree_;
  }

 private:
  // The state for the octree, which has no clear voxels.
  static Voxel seen(Voxel state) { return state == Voxel::kClear ? Voxel::kUnknown : state; }

  /// Returns the state that all voxels of the cube share, or −1.
  int uniform(const Eigen::Vector3i& low, int edge) const {
    const Voxel first = seen(grid_.at(low.x(), low.y(), low.z()));
    for (int k = low.z(); k < low.z() + edge; ++k) {
      for (int j = low.y(); j < low.y() + edge; ++j) {
        const Voxel* row = &grid_.states()[grid_.index(low.x(), j, k)];
        for (int i = 0; i < edge; ++i) {
          if (seen(row[i]) != first) return -1;
        }
      }
    }
    return static_cast<int>(first);
  }

  static bool absent(int state) { return state == static_cast<int>(Voxel::kUnknown); }

  void write_block(const Eigen::Vector3i& low) {
    const int state = uniform(low, OccupancyGrid::kBlock);
    if (absent(state)) return;
    constexpr int kDepth = 12;  // blocks of 16 voxels lie 4 above the leaves of 16 levels
    if (!tree_->getRoot()) tree_ = std::make_shared<RootedTree>(grid_.resolution());
    octomap::OcTreeNode* node = tree_->getRoot();
    const Eigen::Vector3i key = grid_.corner() + low + Eigen::Vector3i::Constant(32768);
    for (int depth = 0; depth < kDepth; ++depth) node = child(node, key, 15 - depth);
    write_node(node, low, OccupancyGrid::kBlock, state);
  }

  octomap::OcTreeNode* child(octomap::OcTreeNode* node, const Eigen::Vector3i& key, int bit) {
    const unsigned n =
        ((key.x() >> bit) & 1) | (((key.y() >> bit) & 1) << 1) | (((key.z() >> bit) & 1) << 2);
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
    for (unsigned n = 0; n < 8; ++n) {
      const Eigen::Vector3i at = low + step * Eigen::Vector3i(n & 1, (n >> 1) & 1, n >> 2);
      const int part = uniform(at, step);
      if (!absent(part)) write_node(tree_->createNodeChild(node, n), at, step, part);
    }
  }

  const OccupancyGrid& grid_;
  std::shared_ptr<octomap::OcTree> tree_;
};

}  // namespace

std::shared_ptr<octomap::OcTree> OccupancyGrid::to_octree() const {
  return TreeWriter(*this).write();
}

}  // namespace quadrille
