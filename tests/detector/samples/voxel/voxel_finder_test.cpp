#include "samples/voxel/voxel_finder.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

constexpr float kFinderEdge = 0.01f;

/// Points in a cube of 0.3 m, far from the origin.
VoxelGrid some_grid() {
  RandomStream random(11, 0);
  std::vector<Vector3f> points;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back(Vector3f(-37.2f, 12.5f, 1.0f) +
                     Vector3f(Eigen::Vector3d(x - 0.5, y - 0.5, z - 0.5).cast<float>()) * 0.3f);
  }
  return VoxelGrid(points, {}, kFinderEdge);
}

std::vector<char> two_thirds(const VoxelGrid& grid) {
  std::vector<char> keep;
  for (int v = 0; v < grid.size(); ++v) keep.push_back(v % 3 != 0);
  return keep;
}

/// The kept voxels whose means lie within a radius of p, by trying all.
std::vector<int> voxels_within(const VoxelGrid& grid, const std::vector<char>& keep,
                               const Vector3f& p, float radius) {
  std::vector<int> voxels;
  for (int v = 0; v < grid.size(); ++v) {
    if (keep[v] && (grid.mean()[v] - p).norm() <= radius) voxels.push_back(v);
  }
  return voxels;
}

}  // namespace

TEST_CASE("the finder finds exactly the kept voxels of each ball", "[voxel]") {
  const VoxelGrid grid = some_grid();
  const std::vector<char> keep = two_thirds(grid);
  for (const float radius : {0.019f, 0.026f, 0.095f}) {
    VoxelFinder finder(grid, radius, keep);
    for (int v = 0; v < grid.size(); v += 17) {
      const Vector3f p = grid.mean()[v];
      std::vector<int> found = finder.within(p);
      std::sort(found.begin(), found.end());
      REQUIRE(found == voxels_within(grid, keep, p, radius));
    }
  }
}

TEST_CASE("the finder's sums are those of the ball, and the nearest are the nearest", "[voxel]") {
  constexpr float kRadius = 0.026f, kReach = 0.019f;
  constexpr int kMax = 9;
  const VoxelGrid grid = some_grid();
  const std::vector<char> keep = two_thirds(grid);
  VoxelFinder finder(grid, kRadius, keep);
  std::vector<int> nearest;
  std::size_t full = 0;
  for (int v = 0; v < grid.size(); v += 7) {
    const Vector3f p = grid.mean()[v];
    const PlaneMoments moments = finder.moments(p, kReach, kMax, &nearest);
    PlaneMoments truth;
    for (const int other : voxels_within(grid, keep, p, kRadius)) {
      truth.add(grid.mean()[other] - p);
    }
    REQUIRE(moments.n == truth.n);
    CHECK((moments.sum - truth.sum).norm() < 1e-6f);
    CHECK((moments.squares - truth.squares).matrix().norm() < 1e-7f);
    CHECK((moments.products - truth.products).matrix().norm() < 1e-7f);
    std::vector<int> near = voxels_within(grid, keep, p, kReach);
    const auto nearer = [&](int a, int b) {
      return (grid.mean()[a] - p).norm() < (grid.mean()[b] - p).norm();
    };
    std::sort(near.begin(), near.end(), nearer);
    if (near.size() > kMax) near.resize(kMax), ++full;
    std::sort(nearest.begin(), nearest.end(), nearer);
    CHECK(nearest == near);
  }
  CHECK(full > 10);
}

TEST_CASE("of equally near voxels as many are the nearest as there is room for", "[voxel]") {
  std::vector<Vector3f> lattice;
  for (int i = 0; i < 1000; ++i) {
    const Vector3f index = Eigen::Vector3i(i % 10, i / 10 % 10, i / 100).cast<float>();
    // Sums of such fractions are exact: distances tie.
    lattice.push_back(0.0078125f * (index + Vector3f::Constant(0.5f)));
  }
  const VoxelGrid grid(lattice, {}, 0.0078125f);
  REQUIRE(grid.size() == 1000);
  VoxelFinder finder(grid, 0.02f);
  std::vector<int> nearest;
  for (int v = 0; v < grid.size(); ++v) {
    const Vector3f p = grid.mean()[v];
    finder.moments(p, 0.015f, 4, &nearest);
    // Itself and three of its three to six neighbours at one edge.
    REQUIRE(nearest.size() == 4);
    CHECK(std::count(nearest.begin(), nearest.end(), v) == 1);
    for (const int near : nearest) CHECK((grid.mean()[near] - p).norm() < 0.0079f);
  }
}

TEST_CASE("a ball far wider than the grid finds all of it, and soon", "[voxel]") {
  const VoxelGrid grid = some_grid();
  VoxelFinder finder(grid, 1e30f);
  CHECK(finder.within({1.0f, 2.0f, 3.0f}).size() == static_cast<std::size_t>(grid.size()));
}
