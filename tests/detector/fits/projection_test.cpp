#include "fits/projection.hpp"

#include <cmath>
#include <limits>

#include "detector/fits/examples.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;

namespace {

Quadric diagonal_quadric(double a, double b, double c, double d) {
  return Quadric(Eigen::Matrix4d(Eigen::Vector4d(a, b, c, d).asDiagonal()));
}

}  // namespace

TEST_CASE("a projected point lies on the surface, its offset along the gradient", "[projection]") {
  RandomStream random(51, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Quadric Q = from_canonical(form).transformed(test::random_pose(random, 0.5)).normalized();
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::Vector3d x =
          Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform()) * 2.0;
      const auto foot = project(Q, x);
      REQUIRE(foot);
      CHECK(std::abs(Q.value(*foot)) < 1e-8);
      CHECK((x - *foot).cross(Q.gradient(*foot)).norm() < 1e-6);
    }
  }
}

TEST_CASE("no sampled point of the surface is nearer than the projection", "[projection]") {
  RandomStream random(52, 0);
  for (const CanonicalForm& form : curved_forms()) {
    CAPTURE(to_string(form.type));
    const Quadric Q = from_canonical(form);
    const auto surface = test::points_on(Q.matrix(), 2000, -1e3, random);
    for (int trial = 0; trial < 10; ++trial) {
      const Eigen::Vector3d x =
          Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform());
      double nearest = std::numeric_limits<double>::infinity();
      for (const OrientedPoint& point : surface) {
        nearest = std::min(nearest, (point.x - x).norm());
      }
      const auto foot = project(Q, x);
      REQUIRE(foot);
      CHECK((*foot - x).norm() <= nearest + 1e-9);
    }
  }
}

TEST_CASE("centres, axes and planes of symmetry project to a point at the right distance",
          "[projection]") {
  const auto distance = [](const Quadric& Q, const Eigen::Vector3d& x) {
    const auto foot = project(Q, x);
    return foot ? (*foot - x).norm() : -1.0;
  };
  CHECK(distance(diagonal_quadric(1, 1, 1, -4), {0, 0, 0}) == Approx(2.0));
  CHECK(distance(diagonal_quadric(1, 1, 0, -0.25), {0, 0, 7}) == Approx(0.5));
  // Ellipsoid with semi-axes 3, 2, 1: the centre is nearest to the ends of the shortest.
  CHECK(distance(diagonal_quadric(1.0 / 9, 0.25, 1, -1), {0, 0, 0}) == Approx(1.0));
  CHECK(distance(diagonal_quadric(0, 0, 1, -0.25), {3, 4, 0}) == Approx(0.5));
  // Cone of half angle 45°: from its axis at right angles to a ruling.
  CHECK(distance(diagonal_quadric(1, 1, -1, 0), {0, 0, 2}) == Approx(std::sqrt(2.0)));
}

TEST_CASE("an imaginary, zero or NaN quadric has no foot", "[projection][degenerate]") {
  const Eigen::Vector3d x(0.1, 0.2, 0.3);
  CHECK_FALSE(project(diagonal_quadric(1, 1, 1, 1), x));
  CHECK_FALSE(project(Quadric(), x));
  CHECK_FALSE(project(diagonal_quadric(1, NAN, 1, -1), x));
  CHECK_FALSE(project(diagonal_quadric(1, 1, 1, -1), {NAN, 0, 0}));
  CHECK_FALSE(project_nearby(diagonal_quadric(1, 1, 1, 1), x));
}

TEST_CASE("near the surface both projections agree", "[projection]") {
  RandomStream random(53, 0);
  const Quadric Q = from_canonical(curved_forms()[1]);
  for (const OrientedPoint& point : test::points_on(Q.matrix(), 50, -1e3, random)) {
    const Eigen::Vector3d x = point.x + 0.05 * point.n;
    const auto global = project(Q, x), local = project_nearby(Q, x);
    REQUIRE(global);
    REQUIRE(local);
    CHECK((*global - *local).norm() < 1e-9);
    CHECK((*local - point.x).norm() < 1e-9);
  }
}
