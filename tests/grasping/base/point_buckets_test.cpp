#include "base/point_buckets.hpp"

#include <algorithm>
#include <random>

#include "support/catch.hpp"

namespace quadrille {

TEST_CASE("all points nearer than an edge are found, each in one cube", "[point_buckets]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.05, 0.05);
  std::vector<Eigen::Vector3d> points(400);
  for (Eigen::Vector3d& p : points) p = {place(random), place(random), place(random)};
  const double edge = 0.012;
  const PointBuckets buckets(points, edge);
  std::size_t count = 0;
  for (std::size_t n = 0; n < buckets.keys().size(); ++n) {
    for (const int i : buckets.members(n)) {
      CHECK(PointBuckets::key_of(points[static_cast<std::size_t>(i)], edge) == buckets.keys()[n]);
      ++count;
    }
  }
  CHECK(count == points.size());
  const std::vector<PointBuckets::Near> near = buckets.near_each();
  REQUIRE(near.size() == buckets.keys().size());
  for (std::size_t n = 0; n < near.size(); ++n) {
    std::vector<int> found;
    for (const std::span<const int> row : near[n])
      found.insert(found.end(), row.begin(), row.end());
    CHECK(found.size() < points.size());
    for (const int i : buckets.members(n)) {
      for (int j = 0; j < static_cast<int>(points.size()); ++j) {
        if ((points[j] - points[i]).norm() < edge) {
          CHECK(std::count(found.begin(), found.end(), j) == 1);
        }
      }
    }
  }
}

TEST_CASE("points far out share the outermost cubes, and none are lost", "[point_buckets]") {
  const std::vector<Eigen::Vector3d> points = {
      {1e12, 0.0, 0.0}, {2e12, 0.0, 0.0}, {-1e12, -1e12, -1e12}, {0.0, 0.0, 0.0}};
  const PointBuckets buckets(points, 0.01);
  REQUIRE(buckets.keys().size() == 3);
  CHECK(buckets.members(2).size() == 2);
  for (std::size_t n = 0; n < 3; ++n) CHECK_FALSE(buckets.near_each()[n][4].empty());
}

TEST_CASE("points on whole millimetres do not change cubes by rounding", "[point_buckets]") {
  for (int k = -40; k <= 40; ++k) {
    const Eigen::Vector3d p(0.001 * k, 0.0025 * k, -0.005 * k);
    CHECK(PointBuckets::key_of(p, 0.0025) ==
          PointBuckets::key_of(p + Eigen::Vector3d::Constant(1e-12), 0.0025));
    CHECK(PointBuckets::key_of(p, 0.0025) ==
          PointBuckets::key_of(p - Eigen::Vector3d::Constant(1e-12), 0.0025));
  }
}

}  // namespace quadrille
