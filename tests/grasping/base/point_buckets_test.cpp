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
  for (const Eigen::Vector3d& p : points) {
    const std::vector<int> near = buckets.near(PointBuckets::key_of(p, edge));
    for (std::size_t j = 0; j < points.size(); ++j) {
      const bool found = std::count(near.begin(), near.end(), static_cast<int>(j)) == 1;
      if ((points[j] - p).norm() < edge) CHECK(found);
    }
    CHECK(near.size() < points.size());
  }
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
