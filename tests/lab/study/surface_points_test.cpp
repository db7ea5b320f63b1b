#include "lab/study/surface_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "lab/physics/bodies.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using study::surface_points;
using study::SurfacePoints;

namespace {

double distance_to(const SurfacePoints& points, const Vector3d& p_C) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3d& q_C : points.p_C) least = std::min(least, (q_C - p_C).norm());
  return least;
}

}  // namespace

TEST_CASE("points lie all over a ball, poles included, with its normals", "[study]") {
  physics::TrueBody ball = test::ball(0.03);
  ball.X_CS.translation() = Vector3d(0.1, 0.2, 0.8);
  const SurfacePoints points = surface_points(ball, 0.002);
  REQUIRE(points.p_C.size() == points.n_C.size());
  for (std::size_t i = 0; i < points.p_C.size(); ++i) {
    const Vector3d r = points.p_C[i] - ball.X_CS.translation();
    CHECK(r.norm() == Approx(0.03));
    CHECK((r.normalized() - points.n_C[i]).norm() < 1e-6);
  }
  for (int k = 0; k < 200; ++k) {
    const double z = 2.0 * k / 199.0 - 1.0, angle = 2.4 * k, s = std::sqrt(1.0 - z * z);
    const Vector3d n(s * std::cos(angle), s * std::sin(angle), z);
    CHECK(distance_to(points, ball.X_CS.translation() + 0.03 * n) < 0.0023);
  }
}

TEST_CASE("flat ends have points where they are there, and none where they are open", "[study]") {
  physics::TrueBody cup = test::cylinder(0.03, 0.02, 0.05);
  cup.open_high = true;
  const SurfacePoints points = surface_points(cup, 0.002);
  CHECK(distance_to(points, Vector3d(0.01, 0.005, -0.05)) < 0.002);
  CHECK(distance_to(points, Vector3d(0.0, 0.0, 0.05)) > 0.019);
}

TEST_CASE("points lie on all six faces of a box", "[study]") {
  const SurfacePoints points = surface_points(test::block({0.03, 0.02, 0.01}), 0.002);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const double half = 0.03 - 0.01 * axis;
      const Vector3d p = side * half * Vector3d::Unit(axis);
      CHECK(distance_to(points, p) < 0.0015);
    }
  }
}
