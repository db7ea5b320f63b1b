// What FCL and OctoMap are known to get wrong or leave to their users, on our paths. What is not on
// them (distances, half-spaces, continuous collision) a check of the sources keeps off.
#include <octomap/OcTree.h>

#include "grasping/mapped_scene.hpp"
#include "quadrille/grasping/shape.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"
#include "support/exact_detection.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kWallAt = 0.4;

/// A region of free space with one wall of voxels across it, 5 mm thick.
OccupancyGrid walled() {
  OccupancyGrid grid({Eigen::Vector3d(-0.1, -0.1, -0.2), Eigen::Vector3d(0.1, 0.1, 0.9)},
                     kResolution);
  PointCloud wall, beyond;
  std::vector<Eigen::Vector3d> eyes;
  for (int i = 0; i < 48; ++i) {
    for (int j = 0; j < 48; ++j) {
      const Eigen::Vector3d p(-0.1175 + kResolution * i, -0.1175 + kResolution * j, kWallAt + 1e-4);
      wall.points.push_back(p.cast<float>());
      beyond.points.push_back(Eigen::Vector3f(p.x(), p.y(), -0.5f));
      eyes.emplace_back(p.x(), p.y(), 1.0);
    }
  }
  grid.add_rays(beyond, eyes);
  grid.add_rays(wall, eyes);
  return grid;
}

}  // namespace

TEST_CASE("a sweep of a metre does not jump over a wall of 5 mm", "[fcl]") {
  const ObstacleMap map(walled(), true);
  const auto sweep = [&](double front) {
    return OrientedBox{Eigen::Matrix3d::Identity(),
                       {0, 0, 0.5 * (front + 0.85)},
                       {0.01, 0.01, 0.5 * (0.85 - front)}};
  };
  CHECK(map.collides(sweep(-0.1)) == Hit::kOccupied);
  CHECK(map.collides(sweep(kWallAt - 1e-6)) == Hit::kOccupied);
  CHECK(map.collides(sweep(kWallAt + kResolution + 1e-6)) == Hit::kNone);
}

TEST_CASE("the octree's inner nodes know their children", "[fcl]") {
  const auto tree = walled().to_octree();
  REQUIRE(tree->getRoot());
  CHECK(tree->isNodeOccupied(tree->getRoot()));
  const OrientedBox at_wall{Eigen::Matrix3d::Identity(),
                            {0, 0, kWallAt + 0.5 * kResolution},
                            Eigen::Vector3d::Constant(0.001)};
  CHECK(overlaps(at_wall, tree));
  for (auto node = tree->begin_tree(); node != tree->end_tree(); ++node) {
    if (node.isLeaf()) continue;
    REQUIRE((*node).getLogOdds() == (*node).getMaxChildLogOdds());
  }
}

TEST_CASE("voxels are as occupied as can be, whatever threshold a reader sets", "[fcl]") {
  const auto tree = walled().to_octree();
  tree->setOccupancyThres(0.9);
  const auto* node = tree->search(0.0, 0.0, kWallAt + 0.5 * kResolution);
  REQUIRE(node);
  CHECK(tree->isNodeOccupied(node));
}

TEST_CASE("an octree of nothing is nothing to run into", "[fcl]") {
  const OccupancyGrid unknown({Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.1)},
                              kResolution);
  const OrientedBox box{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Constant(0.1)};
  CHECK_FALSE(overlaps(box, std::shared_ptr<const octomap::OcTree>(unknown.to_octree())));
  CHECK_FALSE(overlaps(box, std::shared_ptr<const octomap::OcTree>()));
  CHECK(overlaps(box, std::shared_ptr<const octomap::OcTree>(unknown.to_octree(true))));
}

TEST_CASE("a small box deep inside a polyhedron collides", "[fcl]") {
  for (const Detection& d : solid_detections()) {
    const Body body = make_body(d).value();
    const OrientedBox inside{Eigen::Matrix3d::Identity(), body.centre_C(),
                             Eigen::Vector3d::Constant(1e-4)};
    bool hit = false;
    for (const CollisionShape& shape : make_shapes(d)) hit |= overlaps(inside, shape);
    CAPTURE(to_string(d.type));
    CHECK(hit);
  }
}
