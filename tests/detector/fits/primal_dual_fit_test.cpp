#include "fits/primal_dual_fit.hpp"

#include <algorithm>

#include "detector/fits/examples.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using quadrille::test::curved_forms;
using quadrille::test::difference;
using quadrille::test::sample;

TEST_CASE("the positions beyond the tangent planes may have any normals", "[fits][paper:fig2a]") {
  RandomStream random(71, 0);
  for (const PrimalDual& kind : kPrimalDual) {
    CAPTURE(kind.points, kind.planes);
    auto s = sample(curved_forms()[1], kind.points, random, true);
    for (int i = kind.planes; i < kind.points; ++i) s.points.normals.col(i) << 0, 0.6, 0.8;
    const auto Q = fit_primal_dual(s.points, kind);
    REQUIRE(Q);
    CHECK(difference(Q->matrix(), s.Q.matrix()) < 1e-6);
  }
}

TEST_CASE(
    "eight points and a plane touched anywhere leave up to three quadrics, the true among them",
    "[fits][paper:def2]") {
  RandomStream random(72, 0);
  std::size_t most = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto s = sample(curved_forms()[trial % 2 ? 1 : 8], 9, random, true);
    const Eigen::Vector3d x = s.points.points.col(8), n = s.points.normals.col(8);
    const Eigen::Vector4d plane(n.x(), n.y(), n.z(), -n.dot(x));
    const auto found = fit_eight_points_and_plane(s.points.points.leftCols(8), plane);
    REQUIRE(!found.empty());
    REQUIRE(found.size() <= 3);
    most = std::max(most, found.size());
    double nearest = 2.0;
    for (const Quadric& Q : found) {
      nearest = std::min(nearest, difference(Q.matrix(), s.Q.matrix()));
      const double tangency = plane.dot(Q.dual() * plane);
      CHECK(std::abs(tangency) < 1e-6 * std::max(1e-6, Q.dual().norm()) * plane.squaredNorm());
    }
    CHECK(nearest < 1e-5);
  }
  CHECK(most == 3);
}

TEST_CASE("too few constraints are the caller's mistake", "[fits]") {
  RandomStream random(73, 0);
  const auto s = sample(curved_forms()[1], 9, random, true);
  CHECK_THROWS_AS(fit_primal_dual(s.points, {8, 0}), std::invalid_argument);
  CHECK_THROWS_AS(fit_primal_dual(s.points, {3, 4}), std::invalid_argument);
  CHECK_THROWS_AS(fit_eight_points_and_plane(s.points.points, Eigen::Vector4d::UnitX()),
                  std::invalid_argument);
  CHECK(fit_eight_points_and_plane(Eigen::Matrix3Xd::Zero(3, 8), Eigen::Vector4d::UnitX()).empty());
}
