#include "variants/web.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "samples/inliers.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A web of two points of a quadric, and the λ of the quadric in it.
struct Known {
  Web web;
  Eigen::Vector3d lambda;
};

std::optional<Known> known_web(const Eigen::Matrix4d& D, const std::vector<OrientedPoint>& points) {
  const auto web = make_web({points[0], points[1]}, 0.0);
  if (!web) return std::nullopt;
  // The web's quadrics have the gradient of Q0 at the first point.
  const double scale = 2.0 * (web->Q0 * points[0].x.homogeneous()).head<3>().norm() /
                       Quadric(D).gradient(points[0].x).norm();
  const Eigen::Matrix3d rest = (scale * D - web->Q0).topLeftCorner<3, 3>();
  const Eigen::Vector3d p = web->p.head<3>(), q = web->q.head<3>();
  return Known{*web, {p.dot(rest * p), 2.0 * p.dot(rest * q), q.dot(rest * q)}};
}

double distance_to(const WebLine& line, const Eigen::Vector3d& lambda) {
  return line.direction.normalized().cross(lambda - line.origin).norm();
}

}  // namespace

TEST_CASE("every member of a web passes through its basis with the normals", "[web][paper:eq6]") {
  RandomStream random(111, 0);
  int families = 0;
  for (const FamilyExample& example : family_examples()) {
    const auto points = points_on(example.D, 2, example.low, random);
    const auto web = make_web({points[0], points[1]}, 0.0);
    if (!web) continue;
    ++families;
    for (int k = 0; k < 4; ++k) {
      const Quadric Q(web->at(Eigen::Vector3d(gaussian(random), gaussian(random), k)));
      CAPTURE(example.name, k);
      for (const OrientedPoint& point : points) {
        CHECK(Q.value(point.x) == Approx(0.0).margin(1e-12));
        CHECK(Q.gradient(point.x).normalized().dot(point.n) == Approx(1.0));
      }
    }
  }
  CHECK(families == 9);
}

TEST_CASE("three further dimensions exhaust the quadrics through two oriented points",
          "[web][paper:fig2]") {
  RandomStream random(112, 0);
  const auto points = points_on(diagonal(1, 1.8, 3, -1), 2, -1e3, random);
  const auto web = make_web({points[0], points[1]}, 0.0);
  REQUIRE(web);
  // Value and gradient at both points, with a free scale each, as eight equations.
  Eigen::Matrix<double, 8, 12> A = Eigen::Matrix<double, 8, 12>::Zero();
  for (int k = 0; k < 10; ++k) {
    Vector10d q = Vector10d::Zero();
    q[k] = 1.0;
    for (int i = 0; i < 2; ++i) {
      A(4 * i, k) = Quadric(q).value(points[i].x);
      A.block<3, 1>(4 * i + 1, k) = Quadric(q).gradient(points[i].x);
    }
  }
  for (int i = 0; i < 2; ++i) A.block<3, 1>(4 * i + 1, 10 + i) = -points[i].n;
  // Twelve unknowns, one of them the scale of the whole.
  CHECK(A.colPivHouseholderQr().rank() == 8);
}

TEST_CASE("a point and its tangent plane leave a line that holds the true λ",
          "[web][paper:theorem3]") {
  RandomStream random(113, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    int checked = 0;
    for (int trial = 0; trial < 10; ++trial) {
      const auto points = points_on(example.D, 30, example.low, random);
      const auto known = known_web(example.D, points);
      if (!known) continue;
      CAPTURE(example.name, trial);
      CHECK(difference(known->web.at(known->lambda), example.D) < 1e-9);
      for (std::size_t i = 2; i < points.size(); ++i) {
        const auto line = line_of(known->web, points[i], 0.1, 0.99);
        if (!line) continue;
        ++checked;
        CHECK(distance_to(*line, known->lambda) < 1e-7 * (1.0 + known->lambda.norm()));
        // All along the line the quadric touches the point.
        const Quadric Q(known->web.at(line->origin + 0.7 * line->direction));
        CHECK(std::abs(Q.value(points[i].x)) < 1e-9);
        CHECK(std::abs(Q.gradient(points[i].x).normalized().dot(points[i].n)) == Approx(1.0));
      }
    }
    CHECK(checked >= 50);
  }
}

TEST_CASE("a foreign or useless voter has no line", "[web][degenerate]") {
  RandomStream random(114, 0);
  const auto points = points_on(diagonal(1, 1, 1, -1), 3, -1e3, random);
  const auto web = make_web({points[0], points[1]}, 0.0);
  REQUIRE(web);
  REQUIRE(line_of(*web, points[2], 0.05, 0.9));
  CHECK_FALSE(line_of(*web, {points[2].x, -points[2].n}, 0.05, 0.9));
  CHECK_FALSE(line_of(*web, points[2], 3.0, 0.9));
  const Eigen::Vector3d middle = 0.5 * (points[0].x + points[1].x);
  CHECK_FALSE(line_of(*web, {middle, points[0].n}, 0.05, -1.0));
  // A normal across the plane of basis and voter tells no scale.
  const Eigen::Vector3d across =
      (points[1].x - points[0].x).cross(points[2].x - points[0].x).normalized();
  CHECK_FALSE(line_of(*web, {points[2].x, across}, 0.05, -1.0));
}

TEST_CASE("points that coincide, or look at each other's backs, have no web", "[web][degenerate]") {
  const OrientedPoint one{{0, 0, 0}, {1, 0, 0}}, other{{1, 0, 0}, {1, 0, 0}};
  CHECK_FALSE(make_web({one, one}, 0.05));
  CHECK_FALSE(make_web({one, other}, 0.05));
  // Doubted normals keep a common scale.
  const OrientedPoint flat{{1, 0, 0}, {-0.02, 0.9998, 0}}, level{{0, 0, 0}, {0.0, 1, 0}};
  const auto doubted = make_web({level, flat}, 0.5);
  REQUIRE(doubted);
  CHECK(2.0 * (doubted->Q0 * Eigen::Vector4d(0, 0, 0, 1)).head<3>().norm() ==
        Approx(1.0).epsilon(0.02));
}
