#include "space/obstacle_map.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <random>

#include "grasping/exact_overlap.hpp"
#include "grasping/mapped_scene.hpp"
#include "grasping/octree_overlap.hpp"
#include "grasping/random_box.hpp"
#include "grasping/seen_space.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"
#include "support/rounds.hpp"
#include "view/depth_view.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

const Eigen::AlignedBox3d kAround(Eigen::Vector3d(-0.1, -0.1, 0.7), Eigen::Vector3d(0.1, 0.1, 0.9));

/// A cube of a grid as a solid.
CollisionShape cube(const Eigen::Vector3d& centre) {
  CollisionShape shape;
  shape.kind = "box";
  shape.dimensions.assign(3, kResolution);
  shape.X_CS.translation() = centre;
  return shape;
}

/// OctoMap's own tree, in which unknown voxels are occupied: FCL lets pass where there is no node.
std::shared_ptr<const octomap::OcTree> tree_of_all_but_free(const OccupancyGrid& grid) {
  auto tree = std::make_shared<octomap::OcTree>(grid.resolution());
  const Eigen::Vector3i size = grid.size();
  for (int k = 0; k < size.z(); ++k) {
    for (int j = 0; j < size.y(); ++j) {
      for (int i = 0; i < size.x(); ++i) {
        if (grid.at(i, j, k) == Voxel::kFree) continue;
        const Eigen::Vector3d p = grid.centre(i, j, k);
        tree->setNodeValue(p.x(), p.y(), p.z(), tree->getClampingThresMaxLog(), true);
      }
    }
  }
  tree->updateInnerOccupancy();
  return tree;
}

bool meets(const OrientedBox& box, const CollisionShape& voxel) {
  const double reach = box.half.norm() + kResolution;
  if ((voxel.X_CS.translation() - box.p_CB).squaredNorm() > reach * reach) return false;
  return ExactSolid(voxel).meets(box);
}

/// The voxels around a box for which holds(state).
template <class Holds>
bool meets_any(const OrientedBox& box, const OccupancyGrid& grid, Holds&& holds) {
  const Eigen::Array3d scale = Eigen::Array3d::Constant(1.0 / kResolution);
  const auto voxel = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3i((p.array() * scale).floor().cast<int>().matrix() - grid.corner());
  };
  const Eigen::Vector3i low = voxel(box.p_CB - box.reach()), high = voxel(box.p_CB + box.reach());
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      for (int i = low.x(); i <= high.x(); ++i) {
        const bool outside = (Eigen::Array3i(i, j, k) < 0).any() ||
                             (Eigen::Array3i(i, j, k) >= grid.size().array()).any();
        if (!holds(outside ? Voxel::kUnknown : grid.at(i, j, k))) continue;
        if (meets(box, cube(grid.centre(i, j, k)))) return true;
      }
    }
  }
  return false;
}

/// Single voxels and small heaps of them, far between.
PointCloud scattered(std::mt19937& random) {
  PointCloud cloud;
  for (int n = 0; n < 40; ++n) {
    const Eigen::Vector3d p = random_point(random, kRegion);
    const int heap = random() % 3 ? 1 : 3;
    for (int m = 0; m < heap * heap * heap; ++m) {
      const Eigen::Vector3d step(m % heap, m / heap % heap, m / heap / heap);
      cloud.points.push_back((p + kResolution * step).cast<float>());
    }
  }
  cloud.viewpoint.setConstant(std::nan(""));  // no view: nothing is free
  return cloud;
}

}  // namespace

TEST_CASE("no overlap of a box and a voxel is missed, nor one told that is none",
          "[occupancy][collision]") {
  std::mt19937 random(14);
  int hits = 0;
  for (int n = 0; n < 4 * rounds(); ++n) {
    const PointCloud cloud = scattered(random);
    const OccupancyGrid grid = map_of(cloud, DepthView(cloud));
    const ObstacleMap map(grid, false);
    const auto occupied = [](Voxel state) { return state == Voxel::kOccupied; };
    const auto judge = [&](const OrientedBox& box) {
      const bool hit = map.collides(box) != Hit::kNone;
      hits += hit;
      if (!hit) REQUIRE_FALSE(meets_any(box.inflated(-2e-9), grid, occupied));
      if (hit) REQUIRE(meets_any(box.inflated(2e-9), grid, occupied));
    };
    for (int k = 0; k < 50; ++k) {
      // A box that just touches one voxel, as far as others let it, a little more or less.
      OrientedBox box = random_box(random, kRegion);
      const Eigen::Vector3d p = cloud.points[random() % cloud.points.size()].cast<double>();
      const CollisionShape voxel =
          cube(((p / kResolution).array().floor() + 0.5).matrix() * kResolution);
      box.p_CB = voxel.X_CS.translation();
      const Eigen::Vector3d d = random() % 2 ? Eigen::Vector3d(random_rotation(random).col(0))
                                             : Eigen::Vector3d::Unit(random() % 3);
      const Eigen::Vector3d away = touching(ExactSolid(voxel), box, d) * d;
      for (const double gap : {-1e-3, -1e-5, -1e-6, -1e-7, -1e-8, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
        judge({box.R_CB, box.p_CB + away + gap * d, box.half});
      }
      for (int m = 0; m < 10; ++m) judge(random_box(random, kRegion));
    }
  }
  CHECK(hits > 500 * rounds());
}

TEST_CASE("a map, and its part around a place, know which voxels are occupied", "[occupancy]") {
  std::mt19937 random(16);
  int occupied = 0;
  for (int n = 0; n < rounds(); ++n) {
    const PointCloud cloud = scattered(random);
    const OccupancyGrid grid = map_of(cloud, DepthView(cloud));
    const ObstacleMap map(grid, false);
    const Eigen::Vector3d middle = kRegion.center();
    const Eigen::AlignedBox3d half(kRegion.min(), middle);
    const ObstacleMap part = map.within(half);
    for (const Eigen::Vector3f& p : cloud.points) {
      for (const double off : {0.0, 0.004, -0.011}) {
        const Eigen::Vector3d p_C = p.cast<double>().array() + off;
        const bool expected = grid.at(p_C) == Voxel::kOccupied;
        occupied += expected;
        CHECK(map.is_occupied(p_C) == expected);
        if (half.contains(p_C)) CHECK(part.is_occupied(p_C) == expected);
      }
    }
    CHECK_FALSE(map.is_occupied(kRegion.max() + Eigen::Vector3d::Constant(0.5)));
  }
  CHECK(occupied > 40);
}

TEST_CASE("unknown space, and all beyond the map, stops a box exactly if the policy says so",
          "[occupancy][collision][policy]") {
  const Scene scene;
  const ObstacleMap map(scene.grid, true);
  const auto blocks = [](Voxel state) { return state != Voxel::kFree; };
  std::mt19937 random(15);
  int hits = 0, misses = 0;
  Eigen::AlignedBox3d region = kRegion;
  region.max() += Eigen::Vector3d::Constant(0.02);
  for (int n = 0; n < 1500 * rounds(); ++n) {
    OrientedBox box = random_box(random, region);
    box.half *= 0.4;
    const bool hit = map.collides(box) != Hit::kNone;
    ++(hit ? hits : misses);
    if (!hit) REQUIRE_FALSE(meets_any(box.inflated(-2e-9), scene.grid, blocks));
    if (hit) REQUIRE(meets_any(box.inflated(2e-9), scene.grid, blocks));
  }
  CHECK(hits > 100);
  CHECK(misses > 100);
}

TEST_CASE("the box test agrees with FCL on the octree", "[occupancy][collision]") {
  const Scene scene;
  const std::shared_ptr<const octomap::OcTree> tree = scene.grid.to_octree();
  const std::shared_ptr<const octomap::OcTree> solid = tree_of_all_but_free(scene.grid);
  const ObstacleMap occupied(scene.grid, false), blocked(scene.grid, true);
  std::mt19937 random(9);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const OrientedBox box = random_box(random, kAround);
    const bool hit = occupied.collides(box) != Hit::kNone;
    REQUIRE(hit == overlaps(box, tree));
    REQUIRE((blocked.collides(box) != Hit::kNone) == overlaps(box, solid));
    hits += hit;
  }
  CHECK(hits > 300);
  CHECK(hits < 2900);
}

TEST_CASE("policies are ordered: free space grows from obstacle to shadow to free",
          "[occupancy][policy]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  const ObstacleMap obstacle(scene.grid, true, {&scene.view, 1}),
      free(scene.grid, false, {&scene.view, 1});
  ObstacleMap shadow(scene.grid, true, {&scene.view, 1});
  shadow.clear_shadow(body, kRegion);
  std::mt19937 random(11);
  int between = 0, above = 0;
  for (int n = 0; n < 4000; ++n) {
    OrientedBox box = random_box(random, kAround);
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

TEST_CASE("the shadow about a target is cleared there as it is everywhere", "[occupancy][policy]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  ObstacleMap all(scene.grid, true, {&scene.view, 1}), near(scene.grid, true, {&scene.view, 1});
  all.clear_shadow(body, kRegion);
  const Eigen::AlignedBox3d region = body.bounds_C();
  near.clear_shadow(body, region);
  // Blocks of 16 voxels that meet the region.
  const Eigen::Vector3d corner = scene.grid.centre(0, 0, 0).array() - 0.5 * kResolution;
  const auto block = [&](const Eigen::Vector3d& p_C) -> Eigen::Array3i {
    return ((p_C - corner) / (16.0 * kResolution)).array().floor().cast<int>();
  };
  const Eigen::Array3i low = block(region.min()), high = block(region.max());
  int freed = 0;
  for (int n = 0; n < scene.grid.size().prod(); ++n) {
    const Eigen::Vector3i size = scene.grid.size();
    const Eigen::Vector3d p_C =
        scene.grid.centre(n % size.x(), n / size.x() % size.y(), n / size.x() / size.y());
    if ((block(p_C) < low).any() || (block(p_C) > high).any()) continue;
    const OrientedBox voxel{Eigen::Matrix3d::Identity(), p_C,
                            Eigen::Vector3d::Constant(0.4 * kResolution)};
    REQUIRE(near.collides(voxel) == all.collides(voxel));
    freed += near.collides(voxel) == Hit::kNone && scene.grid.at(p_C) == Voxel::kUnknown;
  }
  CHECK(freed > 500);
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

TEST_CASE("the cube that a box met last stops no box after it was freed", "[occupancy][carve]") {
  const Scene scene;
  const Body body = make_body(sphere_detection(scene.balls[0])).value();
  const auto keep_none = [](const Eigen::Vector3d&) { return false; };
  // Only maps on which unknown space is no obstacle remember what a box met last.
  const ObstacleMap map(scene.grid, false);
  ObstacleMap fresh = map;
  fresh.carve(body, 0.006, keep_none);
  std::mt19937 random(17);
  Eigen::AlignedBox3d around = body.bounds_C();
  around.min().array() -= 0.02;
  around.max().array() += 0.02;
  int hits = 0, freed = 0;
  for (int n = 0; n < 1000; ++n) {
    OrientedBox box = random_box(random, around);
    box.half *= 0.3;
    // A map of its own, which remembers nothing but what this box met.
    ObstacleMap remembering = map;
    const bool hit = remembering.collides(box) != Hit::kNone;
    remembering.carve(body, 0.006, keep_none);
    const Hit now = remembering.collides(box);
    REQUIRE(now == ObstacleMap(fresh).collides(box));
    hits += hit;
    freed += hit && now == Hit::kNone;
  }
  CHECK(freed > 50);
  CHECK(hits > freed + 50);
}

TEST_CASE("refined, a box may enter the seen parts of voxels and no hidden ones",
          "[occupancy][collision]") {
  const Scene scene;
  constexpr double kCoarse = 0.008;  // so that its eighths are larger than pixels
  const OccupancyGrid grid = map_of(scene.cloud, scene.view, kRegion, kCoarse);
  const ObstacleMap coarse(grid, true);
  // A second view from the same place shows nothing new, but points of several views are not exact
  // to each other, so that occupied voxels stay whole.
  const bool sole = GENERATE(true, false);
  const std::vector<DepthView> views(sole ? 1 : 2, scene.view);
  const ObstacleMap fine(grid, true, views);
  const SeenSpace space(scene.view);
  std::mt19937 random(11);
  int opened = 0, blocked = 0, unknown = 0, occupied = 0;
  for (int n = 0; n < 20000; ++n) {
    OrientedBox box = random_box(random, kAround);
    box.half *= 0.2;
    const Hit hit = fine.collides(box);
    if (hit != Hit::kNone) {
      blocked += coarse.collides(box) == hit;
      continue;
    }
    opened += coarse.collides(box) != Hit::kNone;
    for (int k = 0; k < 30; ++k) {
      const Eigen::Vector3d p_C = random_point(random, {box.p_CB - box.half, box.p_CB + box.half});
      if (!box.contains(p_C)) continue;
      // An eighth, or if it was hidden in part an eighth of that.
      const auto seen = [&](double edge) {
        const Eigen::Array3d cell = (p_C / edge).array().floor();
        return space.free((cell + 0.5) * edge, 0.5 * edge - 1e-9);
      };
      const Voxel state = grid.at(p_C);
      if (state == Voxel::kUnknown) {
        REQUIRE((seen(0.5 * kCoarse) || seen(0.25 * kCoarse)));
        ++unknown;
      } else if (state == Voxel::kOccupied) {
        REQUIRE(sole);
        REQUIRE(seen(0.5 * kCoarse));
        ++occupied;
      }
    }
  }
  CHECK(opened > 20);
  CHECK(unknown > 20);
  CHECK((occupied > 20) == sole);
  CHECK(blocked > 1000);
}
