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

TEST_CASE("voxels give way alike if whole cubes are asked first", "[occupancy]") {
  const Scene scene;
  ObstacleMap map(scene.grid, false), same(scene.grid, false);
  const Eigen::Vector3d n_C = Eigen::Vector3d(0.3, -0.2, 0.9).normalized();
  const double offset = n_C.dot(0.5 * (kRegion.min() + kRegion.max())), near = 0.021;
  const auto frees = [&](const Eigen::Vector3d& centre_C) {
    return std::abs(n_C.dot(centre_C) - offset) < near;
  };
  int left_out = 0, asked = 0;
  map.free_occupied(frees);
  same.free_occupied(
      [&](const Eigen::Vector3d& middle_C, double half) {
        const double distance = std::abs(n_C.dot(middle_C) - offset);
        const bool may = distance < near + half * n_C.cwiseAbs().sum();
        (may ? asked : left_out) += 1;
        return may;
      },
      frees);
  CHECK(left_out > 0);
  CHECK(asked > 0);
  const Eigen::Vector3i size = scene.grid.size();
  int given_way = 0;
  for (int n = 0; n < size.prod(); ++n) {
    const int i = n % size.x(), j = n / size.x() % size.y(), k = n / (size.x() * size.y());
    const Eigen::Vector3d centre = scene.grid.centre(i, j, k);
    CHECK(same.is_occupied(centre) == map.is_occupied(centre));
    given_way += scene.grid.at(i, j, k) == Voxel::kOccupied && !map.is_occupied(centre);
  }
  CHECK(given_way > 100);
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
