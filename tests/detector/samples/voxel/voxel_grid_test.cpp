#include "samples/voxel/voxel_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3f;

namespace {

constexpr float kEdge = 0.01f;

/// Points in a cube of 0.3 m about a centre.
std::vector<Vector3f> cube_of_points(const Vector3f& centre, int count) {
  RandomStream random(11, 0);
  std::vector<Vector3f> points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back(centre +
                     Vector3f(Eigen::Vector3d(x - 0.5, y - 0.5, z - 0.5).cast<float>()) * 0.3f);
  }
  return points;
}

std::array<int, 3> voxel_at(const Vector3f& p) {
  std::array<int, 3> index{};
  for (int k = 0; k < 3; ++k) {
    index[k] = static_cast<int>(std::floor(static_cast<double>(p[k]) / static_cast<double>(kEdge)));
  }
  return index;
}

}  // namespace

TEST_CASE("voxels hold the mean and the number of their points", "[voxel]") {
  // Across the origin, and far from it.
  for (const Vector3f& centre : {Vector3f(0, 0, 0), Vector3f(-37.2f, 12.5f, 104.0f)}) {
    const std::vector<Vector3f> points = cube_of_points(centre, 20000);
    std::vector<int> of_point;
    const VoxelGrid grid(points, {}, kEdge, &of_point);
    std::map<std::array<int, 3>, std::vector<int>> truth;
    for (int i = 0; i < 20000; ++i) truth[voxel_at(points[i])].push_back(i);
    REQUIRE(grid.size() == static_cast<int>(truth.size()));
    for (const auto& [index, members] : truth) {
      const int v = of_point[members[0]];
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int i : members) {
        CHECK(of_point[i] == v);
        sum += points[i].cast<double>();
      }
      CHECK(grid.count()[v] == static_cast<int>(members.size()));
      const Eigen::Vector3d mean = sum / static_cast<double>(members.size());
      CHECK((grid.mean()[v].cast<double>() - mean).norm() < 1e-5);
    }
  }
}

TEST_CASE("weights count, and points that are not finite do not", "[voxel][degenerate]") {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Vector3f> points = {
      {0.001f, 0, 0}, {0.005f, 0, 0}, {kNone, 0, 0}, {1e30f, 0, 0}};
  std::vector<int> of_point;
  const VoxelGrid grid(points, std::vector<int>{3, 1, 7, 2}, kEdge, &of_point);
  REQUIRE(grid.size() == 2);
  CHECK(of_point == std::vector<int>{0, 0, -1, 1});
  CHECK(grid.count() == std::vector<int>{4, 2});
  CHECK(grid.mean()[0].x() == Approx(0.002f));
  CHECK(VoxelGrid({}, {}, kEdge).size() == 0);
}

TEST_CASE("voxels are numbered alike whatever the order of the points", "[voxel]") {
  std::vector<Vector3f> points = cube_of_points({0.1f, -0.2f, 0.9f}, 3000);
  std::vector<int> forward, backward;
  const VoxelGrid grid(points, {}, kEdge, &forward);
  std::reverse(points.begin(), points.end());
  const VoxelGrid other(points, {}, kEdge, &backward);
  std::reverse(backward.begin(), backward.end());
  CHECK(forward == backward);
  CHECK(grid.count() == other.count());
}

TEST_CASE("more than four million bricks are found as fast as a few", "[voxel]") {
  // One point in each brick. More bricks than 2²² need more bits of their hash than 22; with fewer,
  // a search passes by a large part of the table, and this takes hours.
  constexpr int kSide = 162, kBricks = kSide * kSide * kSide;
  static_assert(kBricks > 1 << 22);
  std::vector<Vector3f> points;
  points.reserve(kBricks);
  for (int n = 0; n < kBricks; ++n) {
    points.push_back(4.0f * kEdge *
                     (Vector3f(static_cast<float>(n % kSide), static_cast<float>(n / kSide % kSide),
                               static_cast<float>(n / kSide / kSide)) +
                      Vector3f::Constant(0.1f)));
  }
  std::vector<int> of_point;
  const VoxelGrid grid(points, {}, kEdge, &of_point);
  CHECK(grid.size() == kBricks);
  CHECK(std::set<int>(of_point.begin(), of_point.begin() + 10000).size() == 10000);
  for (int n = 0; n < kBricks; n += 997) {
    REQUIRE(grid.voxel_of(points[n]) == of_point[n]);
    REQUIRE(grid.mean()[of_point[n]] == points[n]);
  }
}
