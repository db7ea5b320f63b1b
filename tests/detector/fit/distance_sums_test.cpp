#include "fit/distance_sums.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// First-order distance f / |∇f|, in double precision.
double residual(const Eigen::Matrix<double, 10, 1>& q, const Eigen::Vector3d& x) {
  const Quadric Q(q);
  return Q.value(x) / Q.gradient(x).norm();
}

/// The sums by central differences, point by point.
Eigen::Matrix<double, 11, 11> by_differences(const std::vector<OrientedPoint>& points,
                                             const Quadric& Q) {
  Eigen::Matrix<double, 11, 11> N = Eigen::Matrix<double, 11, 11>::Zero();
  const double h = 1e-6;
  for (const OrientedPoint& p : points) {
    Eigen::Matrix<double, 11, 1> row;
    for (int k = 0; k < 10; ++k) {
      Eigen::Matrix<double, 10, 1> more = Q.coefficients(), less = Q.coefficients();
      more[k] += h, less[k] -= h;
      row[k] = (residual(more, p.x) - residual(less, p.x)) / (2 * h);
    }
    row[10] = residual(Q.coefficients(), p.x);
    N += row * row.transpose();
  }
  return N;
}

}  // namespace

TEST_CASE("the normal equations are those of differences, for any number of points",
          "[distance_sums]") {
  RandomStream random(91, 0);
  for (const FamilyExample& example : family_examples()) {
    // Below, at and above whole chunks of points.
    for (const int count : {9, 127, 128, 129, 300}) {
      CAPTURE(example.name, count);
      std::vector<OrientedPoint> points = points_on(example.D, count, example.low, random);
      for (OrientedPoint& p : points) p.x += 0.05 * gaussian(random) * p.n;
      const Quadric Q = Quadric(example.D).normalized();
      const auto expected = by_differences(points, Q);
      const auto fit_points = to_fit_points(points);
      DistanceSums sums(fit_points);
      const auto N = sums.evaluate(Q.matrix()).normal_equations();
      CHECK((N - expected).norm() < 1e-3 * expected.norm());
      CHECK(N(10, 10) == Approx(expected(10, 10)).epsilon(1e-3));
      CHECK(sums.squares() == Approx(expected(10, 10)).epsilon(1e-3));
      const auto exact_points = to_oriented_points<double>(points);
      DistanceSums exact(exact_points);
      exact.evaluate(Q.matrix());
      CHECK((exact.normal_equations() - expected).norm() < 1e-6 * expected.norm());
      CHECK(exact.squares() == Approx(expected(10, 10)).epsilon(1e-9));
    }
  }
}

TEST_CASE("no point gives sums of zero", "[distance_sums]") {
  const OrientedPointsf none(0);
  DistanceSums sums(none);
  CHECK(sums.evaluate(Eigen::Matrix4d::Identity()).normal_equations().norm() == 0.0);
  CHECK(sums.squares() == 0.0);
}
