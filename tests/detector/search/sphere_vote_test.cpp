#include "search/sphere_vote.hpp"

#include <cmath>

#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

VoteOptions vote_options() {
  VoteOptions options;
  options.min_height = 0.1;
  return options;
}

/// Points of the unit sphere's half that faces z, scaled, moved and seen from inside or outside.
std::vector<OrientedPoint> sphere_points(double radius, bool inside, RandomStream& random) {
  std::vector<OrientedPoint> points = points_on(diagonal(1, 1, 1, -1), 200, 0.0, random);
  for (OrientedPoint& p : points) {
    p.x = radius * p.x + Eigen::Vector3d(0.1, -0.2, 0.3);
    if (inside) p.n = -p.n;
  }
  return points;
}

}  // namespace

TEST_CASE("a tangent sphere touches its point and has its curvature", "[sphere_vote]") {
  const OrientedPoint point{{0.3, -0.1, 0.7}, Eigen::Vector3d(1, 2, -2).normalized()};
  for (const double curvature : {4.0, 0.5, -2.0}) {
    const Quadric Q(tangent_sphere(point, curvature));
    CHECK(std::abs(Q.value(point.x)) < 1e-12);
    CHECK((Q.gradient(point.x) - point.n).norm() < 1e-12);
    CHECK(canonical_form(Q).type == QuadricType::kSphere);
    CHECK(canonical_form(Q).dimensions[0].second == Approx(1.0 / std::abs(curvature)));
  }
  CHECK(canonical_form(Quadric(tangent_sphere(point, 0.0))).type == QuadricType::kPlane);
}

TEST_CASE("the highest peak is the sphere's curvature, negative from inside", "[sphere_vote]") {
  RandomStream random(95, 0);
  for (const double radius : {0.6, 1.0, 2.0}) {
    for (const bool inside : {false, true}) {
      CAPTURE(radius, inside);
      const std::vector<OrientedPoint> points = sphere_points(radius, inside, random);
      const auto peaks = vote_curvature(points[0], to_fit_points(points), vote_options());
      REQUIRE(!peaks.empty());
      // A bin of 48 is 65 mrad wide.
      CHECK(std::abs(std::atan(peaks[0].lambda) - std::atan((inside ? -1 : 1) / radius)) < 0.065);
    }
  }
}

TEST_CASE("points with other normals do not vote", "[sphere_vote]") {
  RandomStream random(96, 0);
  std::vector<OrientedPoint> points = sphere_points(1.0, false, random);
  const OrientedPoint basis = points[0];
  for (OrientedPoint& p : points) p.n = p.n.unitOrthogonal();
  CHECK(vote_curvature(basis, to_fit_points(points), vote_options()).empty());
}
