#include "fit/closed_form/taubin.hpp"

#include "fit/closed_form/point_moments.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the scatters are the sums that they stand for", "[taubin]") {
  RandomStream random(96, 0);
  const auto points = points_on(diagonal(1, 1.8, 3, -1), 50, -1e3, random);
  Matrix10d values = Matrix10d::Zero(), gradients = Matrix10d::Zero();
  for (const OrientedPoint& p : points) {
    const auto G = monomial_gradients(p.x);
    values += monomials(p.x) * monomials(p.x).transpose();
    gradients += G.transpose() * G;
  }
  const Matrix10d exact = scatter_of_values(to_oriented_points<double>(points));
  CHECK((exact - values).norm() < 1e-12 * values.norm());
  CHECK((scatter_of_gradients(exact) - gradients).norm() < 1e-12 * gradients.norm());
}

TEST_CASE("Taubin's distances tell whether another quadric fits as well", "[taubin]") {
  RandomStream random(97, 0);
  const auto ellipsoid = points_on(diagonal(1, 1.8, 3, -1), 50, -1e3, random);
  const auto one = solve_taubin(scatter_of_values(to_oriented_points<double>(ellipsoid)), 0.0);
  REQUIRE(one);
  CHECK(difference(Quadric(one->q).matrix(), diagonal(1, 1.8, 3, -1)) < 1e-9);
  CHECK(one->distances[1] > 1e-6 * one->distances[8]);
  // A circle lies on many quadrics.
  std::vector<OrientedPoint> ring;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d x(std::cos(0.2 * i), std::sin(0.2 * i), 0.0);
    ring.push_back({x, x});
  }
  const auto many = solve_taubin(scatter_of_values(to_oriented_points<double>(ring)), 1e-9);
  if (many) CHECK(many->distances[1] < 1e-9 * many->distances[8]);
}

TEST_CASE("points in one place have no quadric of least distance", "[taubin]") {
  std::vector<OrientedPoint> points;
  for (int i = 0; i < 30; ++i) {
    points.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(std::cos(i), std::sin(i), 0.0)});
  }
  CHECK_FALSE(least_taubin(scatter_of_values(to_oriented_points<double>(points)), 1e-9));
}

TEST_CASE("inverse iteration finds Taubin's quadric of least distance", "[taubin]") {
  for (const FamilyExample& example : family_examples()) {
    // On a plane other quadrics fit as well.
    if (example.family == Family::kPlane) continue;
    RandomStream random(98, static_cast<std::uint64_t>(example.family));
    const PointMoments moments(make_points(example, 200, 0.01, random).points);
    const auto all = solve_taubin(moments.values, 1e-9);
    const auto least = least_taubin(moments.values, 1e-9);
    REQUIRE((all && least));
    CAPTURE(example.name, all->distances[1] / all->distances[0]);
    CHECK(difference(Quadric(*least).matrix(), Quadric(all->q).matrix()) < 1e-3);
  }
}
