#include "variants/web_vote.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::vector<OrientedPoint> strangers(int count, RandomStream& random) {
  std::vector<OrientedPoint> list;
  for (int k = 0; k < count; ++k) {
    const Eigen::Isometry3d X = random_pose(random, 1.0);
    list.push_back({X.translation(), X.linear().col(0)});
  }
  return list;
}

/// Of some trials with two points of the quadric as basis, how many have it as their first peak.
/// @param noise  of the positions along the normals; that of the normals is three times that
int elected(const FamilyExample& example, int trials, int outliers, RandomStream& random,
            double noise = 0.0, double least = 0.02) {
  int count = 0;
  for (int k = 0; k < trials;) {
    std::vector<OrientedPoint> points = points_on(example.D, 200, example.low, random);
    const auto web = make_web({points[0], points[1]}, 0.0);
    if (!web) continue;
    ++k;
    for (OrientedPoint& point : points) {
      point.x += noise * gaussian(random) * point.n;
      for (double& n : point.n) n += 3.0 * noise * gaussian(random);
      point.n.normalize();
    }
    for (const OrientedPoint& point : strangers(outliers, random)) points.push_back(point);
    const auto peaks = vote(*web, to_fit_points(points), {});
    count += !peaks.empty() && difference(web->at(peaks[0].lambda), example.D) < least;
  }
  return count;
}

}  // namespace

TEST_CASE("the lines of one quadric's points elect it, a third of outliers or not",
          "[vote][web][paper:fig2]") {
  RandomStream random(121, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    CAPTURE(example.name);
    CHECK(elected(example, 20, 0, random) == 20);
    CHECK(elected(example, 20, 100, random) >= 18);
  }
}

TEST_CASE("noise that scatters the lines over cells side by side costs few elections",
          "[vote][web]") {
  RandomStream random(125, 0);
  int sum = 0;
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    sum += elected(example, 40, 200, random, 0.04, 0.2);
  }
  // Of 320; without smoothing 302.
  CHECK(sum >= 314);
}

TEST_CASE("the peak of a spheroid's web is its λ to rounding", "[vote][web]") {
  // Both poles' neighbours as basis: p and q are x and y up to a turn.
  const Eigen::Matrix4d D = diagonal(1, 1, 2, -1);
  RandomStream random(122, 0);
  const auto points = points_on(D, 150, -1e3, random);
  const auto web = make_web({points[0], points[1]}, 0.0);
  REQUIRE(web);
  const auto peaks = vote(*web, to_fit_points(points), {});
  REQUIRE_FALSE(peaks.empty());
  CHECK(difference(web->at(peaks[0].lambda), D) < 1e-3);
  CHECK(peaks[0].votes > 75);
}

TEST_CASE("votes come most first and no more of them than asked for", "[vote][web]") {
  RandomStream random(123, 0);
  std::vector<OrientedPoint> points = points_on(diagonal(1, 1, 1, -0.81), 100, -1e3, random);
  for (const OrientedPoint& point : strangers(60, random)) points.push_back(point);
  const auto web = make_web({points[0], points[1]}, 0.0);
  REQUIRE(web);
  VoteOptions options;
  options.peaks = 4;
  const auto peaks = vote(*web, to_fit_points(points), options);
  REQUIRE(peaks.size() >= 2);
  for (std::size_t k = 1; k < peaks.size(); ++k) CHECK(peaks[k - 1].votes >= peaks[k].votes);
  options.peaks = 1;
  CHECK(vote(*web, to_fit_points(points), options).size() == 1);
}

TEST_CASE("without voters, or with voters in one plane, nothing is elected",
          "[vote][web][degenerate]") {
  RandomStream random(124, 0);
  const auto points = points_on(diagonal(1, 1, 1, -1), 2, -1e3, random);
  const auto web = make_web({points[0], points[1]}, 0.0);
  REQUIRE(web);
  CHECK(vote(*web, OrientedPointsf(), {}).empty());
  const std::vector<OrientedPoint> same(20, points_on(diagonal(1, 1, 1, -1), 1, -1e3, random)[0]);
  CHECK(vote(*web, to_fit_points(same), {}).empty());
  OrientedPointsf broken = to_fit_points(same);
  broken.points.row(0).setConstant(std::nanf(""));
  CHECK(vote(*web, broken, {}).empty());
}
