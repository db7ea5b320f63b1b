#include <octomap/octomap.h>

#include <random>

#include "io/planner/octree_file.hpp"
#include "support/catch.hpp"
#include "view/scene/octree_leaves.hpp"
#include "view/scene/voxel_layers.hpp"

using namespace quadrille;

namespace {

std::span<const std::uint8_t> span_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

TEST_CASE("only voxels beside free space are shown", "[view][voxels]") {
  view::VoxelBlock block{0.1, Eigen::Vector3d::Zero(), Eigen::Vector3i(5, 5, 5), {}};
  block.states.assign(125, Voxel::kFree);
  for (int n = 0; n < 27; ++n) block.at(1 + n % 3, 1 + n / 3 % 3, 1 + n / 9) = Voxel::kUnknown;
  const auto layers = view::layers_of(block, 1000);
  CHECK(layers.unknown.size() == 26);
  CHECK(layers.occupied.empty());
  CHECK(layers.edge == 0.1);
  const auto coarse = view::layers_of(block, 20);
  CHECK(coarse.edge == 0.2);
  CHECK(coarse.unknown.size() <= 20);
}

TEST_CASE("an octree's stream gives the voxels that OctoMap finds in it", "[view][voxels]") {
  octomap::OcTree tree(0.05);
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) {
    const auto coordinate = [&] {
      return 0.05 * (static_cast<double>(random() % 40) - 20.0) + 0.025;
    };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    tree.updateNode(
        octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
        i % 3 == 0);
  }
  tree.toMaxLikelihood();
  tree.prune();
  const std::string stream = io::octree_bytes(tree);
  const auto block = view::read_octree(span_of(stream), tree.getResolution());
  REQUIRE(block);
  CHECK(block->edge == Approx(0.05));
  for (int k = 0; k < block->size.z(); ++k) {
    for (int j = 0; j < block->size.y(); ++j) {
      for (int i = 0; i < block->size.x(); ++i) {
        const Eigen::Vector3d p = block->corner + 0.05 * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5);
        const auto* node = tree.search(p.x(), p.y(), p.z());
        const Voxel expected = node == nullptr             ? Voxel::kUnknown
                               : tree.isNodeOccupied(node) ? Voxel::kOccupied
                                                           : Voxel::kFree;
        REQUIRE(block->at(i, j, k) == expected);
      }
    }
  }
}

TEST_CASE("octrees that are cut short, endless or none are refused", "[view][voxels][hostile]") {
  octomap::OcTree tree(0.05);
  tree.updateNode(octomap::point3d(0.1f, 0.1f, 0.1f), true);
  const std::string stream = io::octree_bytes(tree);
  for (std::size_t size = 0; size < stream.size(); ++size) {
    CHECK(!view::read_octree(span_of(stream.substr(0, size)), 0.05));
  }
  const std::string head = stream.substr(0, stream.find("\ndata\n") + 6);
  // Inner nodes for ever.
  CHECK(!view::read_octree(span_of(head + std::string(1000000, '\xff')), 0.05));
  // A tree of leaves that would fill all of the space is told in large voxels.
  const auto large = view::read_octree(span_of(head + std::string("\xaa\xaa")), 0.05);
  REQUIRE(large);
  CHECK(static_cast<double>(large->states.size()) <= view::kMaxBlockVoxels);
}
