#include "fit/normalisation.hpp"

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("points are normalised about their centroid by either radius", "[normalisation]") {
  RandomStream random(94, 0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 40; ++i) {
    points.emplace_back(3.0 + gaussian(random), 2.0 * gaussian(random), gaussian(random));
  }
  const auto at = [&](std::size_t i) { return points[i]; };
  const Normalisation mean =
      normalisation_about_centroid(points.size(), Radius::kRootMeanSquare, at);
  const Normalisation ball = normalisation_about_centroid(points.size(), Radius::kLargest, at);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0, largest = 0.0;
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d local = (x - mean.centre) / mean.scale;
    sum += local;
    squares += local.squaredNorm();
    largest = std::max(largest, (x - ball.centre).norm() / ball.scale);
  }
  CHECK(sum.norm() < 1e-12);
  CHECK(squares == Approx(40.0));
  CHECK(largest == Approx(1.0));
}
