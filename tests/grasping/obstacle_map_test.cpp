#include "quadrille/grasping/obstacle_map.hpp"

#include <octomap/OcTree.h>

#include <algorithm>

#include "mapped_scene.hpp"
#include "quadrille/grasping/collision.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

OrientedBox random_box(std::mt19937& random) {
  OrientedBox box;
  box.R_CB = random_rotation(random);
  box.p_CB =
      random_point(random, {Eigen::Vector3d(-0.1, -0.1, 0.7), Eigen::Vector3d(0.1, 0.1, 0.9)});
  for (int i = 0; i < 3; ++i) box.half[i] = uniform(random, 0.002, 0.03);
  return box;
}

}  // namespace

TEST_CASE("the box test agrees with FCL on the octree", "[occupancy][collision]") {
  const Scene scene;
  const std::shared_ptr<const octomap::OcTree> tree = scene.grid.to_octree();
  const std::shared_ptr<const octomap::OcTree> solid = scene.grid.to_octree(true);
  const ObstacleMap occupied(scene.grid, false), blocked(scene.grid, true);
  std::mt19937 random(9);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const OrientedBox box = random_box(random);
    const bool hit = occupied.collides(box) != Hit::kNone;
    REQUIRE(hit == overlaps(box, tree));
    REQUIRE((blocked.collides(box) != Hit::kNone) == overlaps(box, solid));
    hits += hit;
  }
  CHECK(hits > 300);
  CHECK(hits < 2900);
}

TEST_CASE("a box is free up to a voxel's face and hits beyond", "[occupancy][collision]") {
  PointCloud cluster;  // a lone point would count as a stray
  for (int i = 0; i < 49; ++i) {
    cluster.points.emplace_back(0.0005F + 0.0005F * (i % 7), 0.0005F + 0.0005F * (i / 7), 0.5025F);
  }
  const OccupancyGrid one(cluster, DepthView(cluster),
                          {Eigen::Vector3d(-0.05, -0.05, 0.45), Eigen::Vector3d(0.05, 0.05, 0.55)},
                          kResolution);
  REQUIRE(one.at({0.0025, 0.0025, 0.5025}) == Voxel::kOccupied);
  const ObstacleMap map(one, false);
  const auto tree = std::shared_ptr<const octomap::OcTree>(one.to_octree());
  for (const double gap : {-1e-4, 1e-4}) {
    const OrientedBox box{Eigen::Matrix3d::Identity(),
                          {0.005 + 0.01 + gap, 0.0025, 0.5025},
                          Eigen::Vector3d::Constant(0.01)};
    CHECK((map.collides(box) != Hit::kNone) == (gap < 0));
    CHECK(overlaps(box, tree) == (gap < 0));
  }
}

TEST_CASE("no box that holds an occupied voxel's centre is told free", "[occupancy][collision]") {
  const Scene scene;
  const ObstacleMap map(scene.grid, false);
  std::vector<Eigen::Vector3d> centres;
  const Eigen::Vector3i size = scene.grid.size();
  for (int k = 0; k < size.z(); ++k) {
    for (int j = 0; j < size.y(); ++j) {
      for (int i = 0; i < size.x(); ++i) {
        if (scene.grid.at(i, j, k) == Voxel::kOccupied)
          centres.push_back(scene.grid.centre(i, j, k));
      }
    }
  }
  std::mt19937 random(10);
  for (int n = 0; n < 1000; ++n) {
    const OrientedBox box = random_box(random);
    const bool holds = std::any_of(centres.begin(), centres.end(),
                                   [&](const Eigen::Vector3d& c) { return box.contains(c); });
    if (holds) REQUIRE(map.collides(box) == Hit::kOccupied);
  }
}

TEST_CASE("policies are ordered: free space grows from obstacle to shadow to free",
          "[occupancy][policy]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  const ObstacleMap obstacle(scene.grid, true), free(scene.grid, false);
  ObstacleMap shadow(scene.grid, true);
  shadow.clear_shadow(scene.grid, scene.view, body, kRegion);
  std::mt19937 random(11);
  int between = 0, above = 0;
  for (int n = 0; n < 4000; ++n) {
    OrientedBox box = random_box(random);
    box.half *= 0.3;
    const bool a = obstacle.collides(box) != Hit::kNone, b = shadow.collides(box) != Hit::kNone;
    const bool c = free.collides(box) != Hit::kNone;
    REQUIRE(a >= b);
    REQUIRE(b >= c);
    between += a && !b;
    above += b && !c;
  }
  CHECK(between > 20);
  CHECK(above > 20);
}

TEST_CASE("carving frees the target and keeps what is asked for", "[occupancy][carve]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  ObstacleMap map(scene.grid, true);
  const OrientedBox inside{Eigen::Matrix3d::Identity(), scene.balls[0].p_C,
                           Eigen::Vector3d::Constant(0.012)};
  const OrientedBox other{Eigen::Matrix3d::Identity(), scene.balls[1].p_C,
                          Eigen::Vector3d::Constant(0.012)};
  REQUIRE(map.collides(inside) != Hit::kNone);
  ObstacleMap kept = map;
  kept.carve(body, 0.006, [](const Eigen::Vector3d&) { return true; });
  CHECK(kept.collides(inside) != Hit::kNone);
  map.carve(body, 0.006, [](const Eigen::Vector3d&) { return false; });
  CHECK(map.collides(inside) == Hit::kNone);
  CHECK(map.collides(other) != Hit::kNone);
}
