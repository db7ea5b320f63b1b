#include "fit/coaxial_fit.hpp"

#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "fit/geometric_fit.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kNoise = 0.01;

/// Parts about one axis, with their own local coordinates.
struct Body {
  Eigen::Isometry3d X_CA = Eigen::Isometry3d::Identity();
  std::vector<OrientedPointsf> points;
  std::vector<std::unique_ptr<DistanceSums<float>>> sums;
  std::vector<CoaxialPart> parts;
};

/// The part of an example whose canonical frame is at a height on the axis. Its local coordinates
/// have half the unit, and its start is disturbed as fits alone are.
void add_part(const FamilyExample& example, double height, bool turned, int count,
              RandomStream& random, Body* body) {
  Eigen::Isometry3d X_CQ = body->X_CA * translation(0.0, 0.0, height);
  if (turned) X_CQ = X_CQ * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  std::vector<OrientedPoint> points = points_on(example.D, count, example.low, random);
  CoaxialPart part;
  part.local.scale = 2.0;
  for (OrientedPoint& point : points) {
    point.x = X_CQ * Eigen::Vector3d(point.x + kNoise * gaussian(random) * point.n);
    part.local.centre += point.x / static_cast<double>(points.size());
  }
  for (OrientedPoint& point : points) point.x = (point.x - part.local.centre) / part.local.scale;
  body->points.push_back(to_fit_points(points));
  body->sums.push_back(std::make_unique<DistanceSums<float>>(body->points.back()));

  PosedQuadric start;
  start.X = X_CQ;
  start.X.translation() = (X_CQ.translation() - part.local.centre) / part.local.scale;
  // In local coordinates lengths are halved.
  const Eigen::Vector4d unit(1.0, 1.0, 1.0, 1.0 / part.local.scale);
  start.D = unit.asDiagonal() * example.D * unit.asDiagonal();
  const std::optional<FamilyFit> alone = refine(body->points.back(), example.family, start, 20);
  REQUIRE(alone);
  part.fit = *alone;
  part.points = body->sums.back().get();
  part.weight = 1.0 / (kNoise * kNoise);
  body->parts.push_back(part);
}

std::vector<FamilyExample> examples_with_axis() {
  std::vector<FamilyExample> examples;
  for (const FamilyExample& example : family_examples()) {
    if (has_one_axis(example.family)) examples.push_back(example);
  }
  return examples;
}

Body make_body(int count, RandomStream& random) {
  Body body;
  body.X_CA = random_pose(random, 0.5);
  double height = -1.5;
  bool turned = false;
  for (const FamilyExample& example : examples_with_axis()) {
    add_part(example, height, turned, count, random, &body);
    height += 1.0;
    turned = !turned;
  }
  return body;
}

double angle_to(const Eigen::Isometry3d& X, const Eigen::Isometry3d& truth) {
  return X.linear().col(2).cross(truth.linear().col(2)).norm();
}

}  // namespace

TEST_CASE("parts of each family with one axis are fitted about a common one", "[fit][law]") {
  RandomStream random(51, 0);
  REQUIRE(examples_with_axis().size() == 4);
  for (int k = 0; k < 5; ++k) {
    const Body body = make_body(60, random);
    const auto joint = fit_coaxial(body.parts, 20);
    REQUIRE(joint);
    double alone = 0.0;
    for (std::size_t i = 0; i < body.parts.size(); ++i) {
      const CoaxialPart& part = body.parts[i];
      CAPTURE(i, part.fit.rss, joint->parts[i].rss);
      const PosedQuadric& posed = joint->parts[i].posed;
      const Eigen::Vector3d origin_C = part.local.centre + 2.0 * posed.X.translation();
      CHECK(angle_to(posed.X, joint->X_CA) < 1e-9);
      CHECK((joint->X_CA.inverse() * origin_C).head<2>().norm() < 1e-9);
      // A fit alone is free of the axis, so it never leaves more.
      CHECK(joint->parts[i].rss > (1.0 - 1e-3) * part.fit.rss);
      CHECK(joint->parts[i].rss < 1.5 * part.fit.rss);
      alone += angle_to(part.fit.posed.X, body.X_CA) / static_cast<double>(body.parts.size());
    }
    CHECK(angle_to(joint->X_CA, body.X_CA) < 0.5 * alone);
  }
}

TEST_CASE("one part about its own axis is fitted as alone", "[fit]") {
  RandomStream random(52, 0);
  for (const FamilyExample& example : examples_with_axis()) {
    CAPTURE(example.name);
    Body body;
    body.X_CA = random_pose(random, 0.5);
    add_part(example, 0.3, false, 200, random, &body);
    const auto joint = fit_coaxial(body.parts, 20);
    REQUIRE(joint);
    CHECK(joint->parts[0].rss == Approx(body.parts[0].fit.rss).epsilon(1e-3));
    CHECK(difference(joint->parts[0].posed.matrix(), body.parts[0].fit.posed.matrix()) < 1e-3);
    const CoaxialCovariance covariance = covariance_of(*joint, std::vector{1.0});
    const Eigen::MatrixXd expected =
        (information(body.points[0], joint->parts[0]).JtJ * body.parts[0].weight * 4.0).inverse();
    CHECK((covariance.between(0, 0) - expected).norm() < 1e-2 * expected.norm());
  }
}

TEST_CASE("the covariance of a joint fit is that of repeated measurements", "[fit][law]") {
  RandomStream random(53, 0);
  const std::vector<FamilyExample> examples = examples_with_axis();
  constexpr int kRounds = 300;
  double sum = 0.0, squares = 0.0, predicted = 0.0;
  for (int k = 0; k < kRounds; ++k) {
    Body body;
    add_part(examples[0], 0.0, false, 60, random, &body);
    add_part(examples[1], 0.8, false, 60, random, &body);
    const auto joint = fit_coaxial(body.parts, 20);
    REQUIRE(joint);
    REQUIRE(joint->parts[0].family == Family::kCylinder);
    // The shape of the cylinder is minus the square of its radius.
    const double shape = joint->parts[0].posed.D(3, 3);
    sum += shape / kRounds;
    squares += shape * shape / kRounds;
    predicted += covariance_of(*joint, std::vector{1.0, 1.0}).between(0, 0)(0, 0) / kRounds;
  }
  CHECK(squares - sum * sum == Approx(predicted).epsilon(0.25));
}

TEST_CASE("parallel cones share their slope, and spheres their centre", "[fit][law]") {
  RandomStream random(55, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family != Family::kCone && example.family != Family::kSphere) continue;
    Body body;
    body.X_CA = random_pose(random, 0.5);
    // The second cone is the first one, higher up; the second sphere lies around the first.
    FamilyExample other = example;
    const bool spheres = example.family == Family::kSphere;
    if (spheres) other.D(3, 3) *= 1.3;
    add_part(example, 0.2, false, 80, random, &body);
    add_part(other, spheres ? 0.2 : 0.4, false, 80, random, &body);
    PosedQuadric &a = body.parts[0].fit.posed, &b = body.parts[1].fit.posed;
    if (spheres) {
      b.X.translation() =
          (body.parts[0].local.centre + body.parts[0].local.scale * a.X.translation() -
           body.parts[1].local.centre) /
          body.parts[1].local.scale;
    } else {
      b.D(2, 2) = a.D(2, 2);
    }
    body.parts[1].parallel_to = 0;
    const auto joint = fit_coaxial(body.parts, 20);
    REQUIRE(joint);
    const auto place_of = [&](std::size_t i) -> Eigen::Vector3d {
      const Normalisation& local = body.parts[i].local;
      return local.centre + local.scale * joint->parts[i].posed.X.translation();
    };
    CHECK(joint->parts[0].posed.D(2, 2) == Approx(joint->parts[1].posed.D(2, 2)).epsilon(1e-9));
    if (spheres) CHECK((place_of(0) - place_of(1)).norm() < 1e-9);
    const Eigen::Vector3d truth = body.X_CA * Eigen::Vector3d(0.0, 0.0, 0.2);
    CHECK((place_of(0) - truth).norm() < 10.0 * kNoise);
    const double growth = joint->parts[0].rss + joint->parts[1].rss;
    CHECK(growth < 1.2 * (body.parts[0].fit.rss + body.parts[1].fit.rss));
    CHECK(covariance_of(*joint, std::vector{1.0, 1.0}).between(0, 1).allFinite());
  }
}

TEST_CASE("points that are no numbers have no joint fit", "[fit][degenerate]") {
  RandomStream random(54, 0);
  Body body = make_body(40, random);
  body.points[1].points(0, 3) = std::numeric_limits<float>::quiet_NaN();
  body.sums[1] = std::make_unique<DistanceSums<float>>(body.points[1]);
  body.parts[1].points = body.sums[1].get();
  CHECK_FALSE(fit_coaxial(body.parts, 10));
}
