#include "lab/bench/oriented_cloud.hpp"

#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "support/catch.hpp"

namespace quadrille::bench {
namespace {

using Eigen::Vector3f;

/// The plane z = 1 + x / 2, a point every 2 mm.
std::vector<Vector3f> make_slope() {
  std::vector<Vector3f> points;
  for (int i = -30; i <= 30; ++i) {
    for (int j = -30; j <= 30; ++j) {
      const float x = 0.002f * static_cast<float>(i);
      points.emplace_back(x, 0.002f * static_cast<float>(j), 1.0f + 0.5f * x);
    }
  }
  return points;
}

TEST_CASE("a slope is thinned to its voxels, with its normal towards the camera",
          "[bench][orient]") {
  const std::vector<Vector3f> slope = make_slope();
  const OrientedCloud cloud = orient(slope, {});
  REQUIRE(cloud.points.size() == cloud.normals.size());
  CHECK(cloud.points.size() > slope.size() / 30);
  CHECK(cloud.points.size() < slope.size() / 4);
  const Vector3f n = Vector3f(0.5f, 0.0f, -1.0f).normalized();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    CHECK(std::abs(n.dot(cloud.points[i] - Vector3f(0, 0, 1))) < 1e-5f);
    CHECK(n.dot(cloud.normals[i]) > 0.999f);
  }
}

TEST_CASE("points that stand alone have no voxel, and few voxels no normal", "[bench][orient]") {
  CHECK(orient({}, {}).points.empty());
  CHECK(orient({{0, 0, 1}, {0.1f, 0, 1}, {0.2f, 0, 1}}, {}).points.empty());
  // Pairs in five voxels side by side.
  std::vector<Vector3f> row;
  for (int i = 0; i < 5; ++i) {
    const float x = 0.006f * (static_cast<float>(i) + 0.5f);
    row.insert(row.end(), {{x, 0.003f, 1.0f}, {x, 0.003f, 1.0f}});
  }
  CHECK(orient(row, {}).points.empty());
}

TEST_CASE("the neighbours are all points of the ball, in ascending order", "[bench][orient]") {
  RandomStream random(5, 0);
  std::vector<Vector3f> points;
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }
  const NeighbourSearch search(points);
  for (const double radius : {0.05, 0.3}) {
    std::vector<int> expected;
    for (int i = 0; i < 500; ++i) {
      if ((points[i] - points[7]).norm() < radius) expected.push_back(i);
    }
    CHECK(search.within(points[7], radius) == expected);
  }
  CHECK(search.within({9, 9, 9}, 0.5).empty());
}

}  // namespace
}  // namespace quadrille::bench
