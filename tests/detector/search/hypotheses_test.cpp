#include "search/hypotheses.hpp"

#include <cmath>

#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The best of some draws.
std::pair<double, double> best_of(BasisKind kind, int draws, const OrientedPointsf& points,
                                  RandomStream& random) {
  std::pair<double, double> best(1e9, 0.0);
  for (int k = 0; k < draws; ++k) {
    for (const Eigen::Matrix4d& Q : draw_hypotheses(kind, points, VoteOptions(), random)) {
      best = std::min(best, mean_agreement(Q, points));
    }
  }
  return best;
}

}  // namespace

TEST_CASE("every kind of basis finds an exact sphere, on the side of its normals", "[hypotheses]") {
  RandomStream random(97, 0);
  const OrientedPointsf points =
      to_fit_points(points_on(diagonal(1, 1, 1, -0.81), 150, 0.0, random));
  for (const BasisKind kind : {BasisKind::kThreePoints, BasisKind::kSphere}) {
    CAPTURE(static_cast<int>(kind));
    const auto [distance, cosine] = best_of(kind, 20, points, random);
    CHECK(distance < 0.02);
    CHECK(cosine > 0.99);
  }
}

TEST_CASE("bases of three points find any quadric", "[hypotheses]") {
  RandomStream random(98, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    const OrientedPointsf points = to_fit_points(points_on(example.D, 200, example.low, random));
    CAPTURE(example.name);
    CHECK(best_of(BasisKind::kThreePoints, 40, points, random).first < 0.05);
  }
}

TEST_CASE("coinciding points draw no hypothesis", "[hypotheses][hostile]") {
  OrientedPointsf points(20);
  points.points.colwise() = Eigen::Vector3f(0.1f, 0.2f, 0.3f);
  points.normals.colwise() = Eigen::Vector3f::UnitX();
  RandomStream random(99, 0);
  for (const BasisKind kind : {BasisKind::kThreePoints, BasisKind::kSphere}) {
    CHECK(draw_hypotheses(kind, points, VoteOptions(), random).empty());
  }
}

TEST_CASE("support counts the points that lie near a quadric, on the side of its normals",
          "[hypotheses]") {
  RandomStream random(100, 0);
  const Eigen::Matrix4d sphere = diagonal(1, 1, 1, -1);
  std::vector<OrientedPoint> points = points_on(sphere, 60, -2.0, random);
  for (int k = 0; k < 20; ++k) points[k].x *= 1.1;
  for (int k = 20; k < 30; ++k) points[k].n *= -1.0;
  CHECK(count_support(to_fit_points(points), sphere, 0.05f, 0.9f) == 30);
  CHECK(count_support(to_fit_points(points), sphere, 0.2f, 0.9f) == 50);
  CHECK(count_support(to_fit_points(points), sphere, 0.2f, -2.0f) == 60);
}

TEST_CASE("the proposal is a hypothesis with the most support of all bases", "[hypotheses]") {
  RandomStream random(103, 0);
  std::vector<OrientedPoint> points = points_on(diagonal(1, 1, 1, -0.81), 60, -2.0, random);
  for (const OrientedPoint& p : points_on(diagonal(1, 1, 0, -0.09), 30, -1.0, random)) {
    points.push_back(p);
  }
  const Voters voters{to_fit_points(points), {}, 0.02f, {}};
  RandomStream draws(104, 0), again(104, 0);
  const Hypothesis best = propose(voters, BasisKind::kThreePoints, 30, draws);
  CHECK(best.support >= 55);
  CHECK(supported(voters, best.Q).support == best.support);
  for (int k = 0; k < 30; ++k) {
    for (const Eigen::Matrix4d& Q :
         draw_hypotheses(BasisKind::kThreePoints, voters.points, voters.vote, again)) {
      CHECK(supported(voters, Q).support <= best.support);
    }
  }
  CHECK(propose(voters, BasisKind::kThreePoints, 0, draws).support == 0);
}
