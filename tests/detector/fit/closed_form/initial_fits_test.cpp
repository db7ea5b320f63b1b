#include "fit/closed_form/initial_cone.hpp"
#include "fit/closed_form/initial_cylinder.hpp"
#include "fit/closed_form/initial_general.hpp"
#include "fit/closed_form/initial_plane.hpp"
#include "fit/closed_form/initial_revolution.hpp"
#include "fit/closed_form/initial_sphere.hpp"
#include "fit/closed_form/special_revolutions.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

FamilyExample example_of(Family family) {
  for (const FamilyExample& example : family_examples()) {
    if (example.family == family) return example;
  }
  throw std::logic_error("no example");
}

/// Largest difference from the truth over some poses of an example.
template <class Fit>
double worst_difference(Family family, Fit&& fit) {
  RandomStream random(41, static_cast<std::uint64_t>(family));
  double worst = 0;
  for (int k = 0; k < 10; ++k) {
    const ExamplePoints data = make_points(example_of(family), 200, 0.0, random);
    const std::optional<PosedQuadric> found = fit(PointMoments(data.points));
    if (!found) return INFINITY;
    worst = std::max(worst, difference(found->matrix(), data.truth.matrix()));
  }
  return worst;
}

PointMoments repeated(const Eigen::Vector3d& x, int count) {
  return PointMoments(to_fit_points(
      std::vector<OrientedPoint>(static_cast<std::size_t>(count), {x, Eigen::Vector3d::UnitZ()})));
}

}  // namespace

TEST_CASE("exact points of each family lead to its quadric in closed form", "[fit][initial]") {
  constexpr double kRounding = 1e-4;  // single precision
  CHECK(worst_difference(Family::kPlane, initial_plane) < kRounding);
  CHECK(worst_difference(Family::kSphere, initial_sphere) < kRounding);
  CHECK(worst_difference(Family::kCylinder, initial_cylinder) < kRounding);
  CHECK(worst_difference(Family::kRevolution, initial_revolution) < 10 * kRounding);
  CHECK(worst_difference(Family::kParaboloid, [](const PointMoments& moments) {
          const auto round = initial_revolution(moments);
          return round ? initial_paraboloid(*round) : std::nullopt;
        }) < 10 * kRounding);
}

TEST_CASE("a cone seen from one side or all around has its half angle in closed form",
          "[fit][initial]") {
  const double slope = 0.6, c = 1 / std::sqrt(1 + slope * slope);
  PosedQuadric truth;
  truth.X = translation(0.1, -0.2, -0.6) *
            Eigen::Isometry3d(Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitX()));
  truth.D = diagonal(1, 1, -slope * slope, 0);
  for (const double turn : {2 * M_PI, M_PI, 1.5}) {
    std::vector<OrientedPoint> points;
    for (int j = 3; j < 13; ++j) {
      for (int i = 0; i < 24; ++i) {
        const double a = turn * i / 24, z = 0.1 * j;
        const Eigen::Vector3d across(std::cos(a), std::sin(a), 0);
        points.push_back({truth.X * (z * (slope * across + Eigen::Vector3d::UnitZ())),
                          truth.X.linear() * (c * (across - slope * Eigen::Vector3d::UnitZ()))});
      }
    }
    CAPTURE(turn);
    const auto cone = initial_cone(PointMoments(to_fit_points(points)));
    REQUIRE(cone);
    CHECK(difference(cone->matrix(), truth.matrix()) < 1e-4);
  }
}

TEST_CASE("Taubin's fit recovers quadrics of every family that is no plane", "[fit][initial]") {
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    CAPTURE(example.name);
    CHECK(worst_difference(example.family, initial_general) < 1e-3);
  }
}

TEST_CASE("tangent cone and cylinder touch a surface of revolution at z = 0", "[fit][initial]") {
  PosedQuadric round;
  RandomStream random(42, 0);
  round.X = random_pose(random, 0.5);
  round.D = diagonal(1, 1, 0.4, -0.5);
  round.D(2, 3) = round.D(3, 2) = -0.2;
  const double r = std::sqrt(0.5);
  const Eigen::Vector3d on = round.X * Eigen::Vector3d(r, 0, 0);
  const auto cone = tangent_cone(round);
  REQUIRE(cone);
  const Quadric surface(round.matrix()), touching(cone->matrix());
  CHECK(std::abs(touching.value(on)) < 1e-12);
  CHECK(touching.gradient(on).normalized().dot(surface.gradient(on).normalized()) ==
        Approx(1.0).epsilon(1e-9));
  const auto cylinder = tangent_cylinder(round);
  REQUIRE(cylinder);
  CHECK(std::abs(Quadric(cylinder->matrix()).value(on)) < 1e-12);
  CHECK((Quadric(cylinder->matrix()).gradient(on).normalized() - round.X.linear().col(0)).norm() <
        1e-9);
}

TEST_CASE("points that determine nothing have no start, or a finite one",
          "[fit][initial][degenerate]") {
  CHECK_FALSE(initial_plane(repeated({0, 0, 0}, 30)));
  CHECK_FALSE(initial_general(repeated({0.1, 0.2, 0.3}, 8)));
  PosedQuadric imaginary;
  imaginary.D = diagonal(1, 1, 1, 1);
  CHECK_FALSE(tangent_cone(imaginary));
  CHECK_FALSE(tangent_cylinder(imaginary));
  CHECK_FALSE(initial_paraboloid(imaginary));
  for (const auto& fit : {initial_plane, initial_sphere, initial_cylinder, initial_cone,
                          initial_revolution, initial_general}) {
    const auto start = fit(repeated({0.1, 0.2, 0.3}, 30));
    CHECK((!start || start->matrix().allFinite()));
  }
}
