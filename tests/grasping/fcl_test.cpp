// What FCL and OctoMap are known to get wrong or leave to their users, on our paths. What is not on
// them (distances, half-spaces, continuous collision) a check of the sources keeps off.
#include <octomap/OcTree.h>

#include "grasping/mapped_scene.hpp"
#include "grasping/octree_overlap.hpp"
#include "quadrille/grasping/shape.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"
#include "support/exact_detection.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr float kWallAt = 0.4f;

/// A wall of points across the region, as an eye on its axis at a height sees it.
PointCloud wall_from(double eye) {
  PointCloud cloud;
  cloud.viewpoint = {0.0, 0.0, eye};
  for (int i = 0; i < 120; ++i) {
    for (int j = 0; j < 120; ++j) {
      cloud.points.emplace_back(-0.119f + 0.002f * i, -0.119f + 0.002f * j, kWallAt + 1e-4f);
    }
  }
  return cloud;
}

/// A region of free space around its axis with one wall of voxels across it, 5 mm thick, seen from
/// either side.
OccupancyGrid walled() {
  SpaceMapper mapper({Eigen::Vector3d(-0.1, -0.1, -0.2), Eigen::Vector3d(0.1, 0.1, 0.9)},
                     kResolution);
  for (const double eye : {-1.5, 2.5}) {
    const PointCloud wall = wall_from(eye);
    mapper.add(wall, DepthView(wall));
  }
  return std::move(mapper).take();
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
                            {0.0025, 0.0025, kWallAt + 0.5 * kResolution},
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
  const auto* node = tree->search(0.0025, 0.0025, kWallAt + 0.5 * kResolution);
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
