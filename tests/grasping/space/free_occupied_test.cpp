// Occupied voxels that give way to something that is known better.
#include <cmath>
#include <random>

#include "grasping/mapped_scene.hpp"
#include "grasping/random_box.hpp"
#include "space/obstacle_map.hpp"
#include "support/catch.hpp"

namespace quadrille {
namespace {

using test::kRegion;
using test::kResolution;
using test::random_box;
using test::Scene;

/// A box far within a voxel.
OrientedBox speck_at(const Eigen::Vector3d& centre_C) {
  return {Eigen::Matrix3d::Identity(), centre_C, Eigen::Vector3d::Constant(1e-4)};
}

/// Whether a voxel is the second of two along x.
bool is_second(const Eigen::Vector3d& centre_C) {
  return static_cast<int>(std::floor(centre_C.x() / kResolution)) % 2 != 0;
}

TEST_CASE("occupied voxels that give way stop nothing, and all others still do", "[occupancy]") {
  const Scene scene;
  ObstacleMap map(scene.grid, false);
  map.free_occupied(is_second);
  int given_way = 0, kept = 0;
  const Eigen::Vector3i size = scene.grid.size();
  for (int n = 0; n < size.prod(); ++n) {
    const int i = n % size.x(), j = n / size.x() % size.y(), k = n / (size.x() * size.y());
    if (scene.grid.at(i, j, k) != Voxel::kOccupied) continue;
    const Eigen::Vector3d centre = scene.grid.centre(i, j, k);
    CHECK(map.is_occupied(centre) != is_second(centre));
    CHECK((map.collides(speck_at(centre)) == Hit::kOccupied) != is_second(centre));
    (is_second(centre) ? given_way : kept) += 1;
  }
  CHECK(given_way > 500);
  CHECK(kept > 500);
}

TEST_CASE("boxes of all sizes pass where all voxels gave way, and nowhere else", "[occupancy]") {
  const Scene scene;
  const ObstacleMap before(scene.grid, false);
  ObstacleMap map(scene.grid, false);
  map.free_occupied([](const Eigen::Vector3d& centre_C) { return centre_C.x() < 0.0; });
  std::mt19937 random(17);
  int passed = 0, stopped = 0;
  for (int n = 0; n < 5000; ++n) {
    const OrientedBox box = random_box(random, kRegion);
    const double reach = box.support(Eigen::Vector3d::UnitX()) - box.p_CB.x();
    if (box.p_CB.x() + reach < 0.0) {
      CHECK(map.collides(box) == Hit::kNone);
      passed += before.collides(box) == Hit::kOccupied;
    } else if (box.p_CB.x() - reach > 0.0) {
      CHECK(map.collides(box) == before.collides(box));
      stopped += before.collides(box) == Hit::kOccupied;
    }
  }
  CHECK(passed > 100);
  CHECK(stopped > 100);
}

}  // namespace
}  // namespace quadrille
