#include "variants/type_bases.hpp"

#include <array>
#include <cmath>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"
#include "variants/draw_variant.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A point of a cylinder (half_angle 0) or cone about z whose radius is 1 at z = 0, as seen from
/// outside or from inside, in a pose and a scale.
struct Body {
  double half_angle;
  Eigen::Isometry3d X;
  double scale;
  bool inwards;

  OrientedPoint at(double angle, double z) const {
    const double rho = 1.0 + z * std::tan(half_angle);
    const Eigen::Vector3d radial(std::cos(angle), std::sin(angle), 0.0);
    const Eigen::Vector3d n =
        std::cos(half_angle) * radial - std::sin(half_angle) * Eigen::Vector3d::UnitZ();
    return {X * Eigen::Vector3d(scale * (rho * radial + z * Eigen::Vector3d::UnitZ())),
            X.linear() * (inwards ? -n : n)};
  }
};

Body random_body(bool cone, RandomStream& random) {
  return {cone ? 0.1 + 1.2 * random.uniform() : 0.0, random_pose(random, 1.0),
          std::pow(10.0, 3.0 * (2.0 * random.uniform() - 1.0)), random.below(2) == 1};
}

/// Largest distance from the quadric, in sizes, and least cosine with its gradient, at points of
/// the body.
std::pair<double, double> errors(const Body& body, const Eigen::Matrix4d& matrix) {
  const Quadric Q(matrix);
  double distance = 0.0, cosine = 1.0;
  for (double angle = 0.0; angle < 6.2; angle += 0.5) {
    for (const double z : {-0.1, 0.0, 0.5}) {
      const OrientedPoint point = body.at(angle, z);
      distance = std::max(distance, std::abs(Q.distance(point.x)) / body.scale);
      cosine = std::min(cosine, Q.gradient(point.x).normalized().dot(point.n));
    }
  }
  return {distance, cosine};
}

template <std::size_t kPoints, class Solver>
void check_exact(bool cone, const Solver& through) {
  RandomStream random(cone ? 8 : 9, 0);
  int solved = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Body body = random_body(cone, random);
    std::array<OrientedPoint, kPoints> basis;
    for (OrientedPoint& point : basis) {
      point = body.at(6.3 * random.uniform(), cone ? random.uniform() : 4.0 * random.uniform());
    }
    const std::optional<Eigen::Matrix4d> Q = through(basis);
    if (!Q) continue;
    ++solved;
    CAPTURE(trial, body.half_angle, body.scale);
    const auto [distance, cosine] = errors(body, *Q);
    CHECK(distance < 1e-9 / std::min(1.0, body.scale));
    CHECK(cosine > 1.0 - 1e-6);
  }
  CHECK(solved > 1200);
}

}  // namespace

TEST_CASE("two oriented points give their cylinder, three their cone, from either side",
          "[type_bases][law]") {
  check_exact<2>(false, cylinder_through);
  check_exact<3>(true, cone_through);
}

TEST_CASE("bases that leave the axis open give nothing", "[type_bases][hostile]") {
  const Body can{0.0, Eigen::Isometry3d::Identity(), 1.0, false};
  CHECK_FALSE(cylinder_through({can.at(1.0, 0.0), can.at(1.0, 2.0)}));
  CHECK_FALSE(cylinder_through({can.at(1.0, 0.0), can.at(1.0 + M_PI, 2.0)}));
  // Three normals of a cylinder lie in a plane: it has no apex.
  CHECK_FALSE(cone_through({can.at(0.0, 0.0), can.at(1.0, 1.0), can.at(2.0, 2.0)}));
}

TEST_CASE("the bases of a type find it among as much of another thing", "[type_bases]") {
  RandomStream random(10, 0);
  for (const bool cone : {false, true}) {
    Body body{cone ? 0.4 : 0.0, random_pose(random, 0.3), 0.5, false};
    std::vector<OrientedPoint> points;
    for (int k = 0; k < 60; ++k)
      points.push_back(body.at(2.5 * random.uniform(), random.uniform()));
    const Eigen::Isometry3d X = random_pose(random, 0.5);
    for (int k = 0; k < 40; ++k) {
      points.push_back(
          {X * Eigen::Vector3d(random.uniform(), random.uniform(), 0.0), X.linear().col(2)});
    }
    const Voters voters{to_fit_points(points), {}, 0.005f, {.min_cosine = 0.95}};
    int most = 0;
    for (int draw = 0; draw < 60; ++draw) {
      const VariantBasis basis = cone ? VariantBasis::kCone : VariantBasis::kCylinder;
      for (const Eigen::Matrix4d& Q : draw_variant({.basis = basis}, voters, random)) {
        most = std::max(most, supported(voters, Q).support);
      }
    }
    CAPTURE(cone);
    CHECK(most >= 60);
    CHECK(most < 75);
  }
}
