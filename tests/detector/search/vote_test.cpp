#include "search/vote.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Three points of a quadric with its gradients, and all points as voters.
struct Ballot {
  Pencil pencil;
  OrientedPointsf voters;
};

Ballot make_ballot(const Eigen::Matrix4d& D, int outliers, RandomStream& random) {
  while (true) {
    std::vector<OrientedPoint> points = points_on(D, 200, -1e3, random);
    std::array<OrientedPoint, 3> basis;
    for (std::size_t i = 0; i < 3; ++i) {
      basis[i] = {points[i].x, Quadric(D).gradient(points[i].x)};
    }
    const auto pencil = make_pencil(basis);
    if (!pencil) continue;
    for (int k = 0; k < outliers; ++k) {
      const Eigen::Isometry3d X = random_pose(random, 1.0);
      points.push_back({X.translation(), X.linear().col(0)});
    }
    return {*pencil, to_fit_points(points)};
  }
}

}  // namespace

TEST_CASE("voters of one quadric of a pencil elect it", "[vote]") {
  // z = 0 is the data plane and f = x² + y² − 1 + λz²: the pencil of all spheroids on that circle.
  Pencil pencil;
  pencil.Q0 = diagonal(1, 1, 0, -1);
  pencil.plane = Eigen::Vector4d(0, 0, 1, 0);
  RandomStream random(21, 0);
  for (const double lambda : {-0.5, 0.4, 1.0, 2.5}) {
    const auto points = points_on(diagonal(1, 1, lambda, -1), 300, -1e3, random);
    const VoteOptions options;
    const std::vector<VotePeak> peaks = vote(pencil, to_fit_points(points), options);
    CAPTURE(lambda);
    REQUIRE(peaks.size() == 1);
    const double bin = M_PI / options.bins;
    CHECK(std::abs(std::atan(peaks[0].lambda) - std::atan(lambda)) < bin);
    CHECK(peaks[0].votes > 50);
  }
}

TEST_CASE("the highest peak passes through a patch of each type, a third of outliers or not",
          "[vote][paper:theorem3]") {
  RandomStream random(22, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    for (const int outliers : {0, 100}) {
      int near = 0;
      constexpr int kTrials = 20;
      for (int k = 0; k < kTrials; ++k) {
        const Ballot ballot = make_ballot(example.D, outliers, random);
        VoteOptions options;
        options.bins = 480;
        const auto peaks = vote(ballot.pencil, ballot.voters, options);
        near += !peaks.empty() && difference(ballot.pencil.at(peaks[0].lambda), example.D) < 0.05;
      }
      CAPTURE(example.name, outliers);
      CHECK(near >= kTrials - 2);
    }
  }
}

TEST_CASE("peaks come highest first and no more of them than asked for", "[vote]") {
  Pencil pencil;
  pencil.Q0 = diagonal(1, 1, 0, -1);
  pencil.plane = Eigen::Vector4d(0, 0, 1, 0);
  RandomStream random(23, 0);
  std::vector<OrientedPoint> points = points_on(diagonal(1, 1, 0.2, -1), 100, -1e3, random);
  for (const auto& p : points_on(diagonal(1, 1, 3.0, -1), 300, -1e3, random)) points.push_back(p);
  VoteOptions options;
  options.peaks = 5;
  const auto peaks = vote(pencil, to_fit_points(points), options);
  REQUIRE(peaks.size() >= 2);
  CHECK(peaks[0].votes > peaks[1].votes);
  CHECK(peaks[0].lambda == Approx(3.0).epsilon(0.25));
  CHECK(peaks[1].lambda == Approx(0.2).margin(0.1));
  options.peaks = 1;
  CHECK(vote(pencil, to_fit_points(points), options).size() == 1);
}

TEST_CASE("voters on the data plane or with foreign normals have no vote", "[vote][degenerate]") {
  Pencil pencil;
  pencil.Q0 = diagonal(1, 1, 0, -1);
  pencil.plane = Eigen::Vector4d(0, 0, 1, 0);
  std::vector<OrientedPoint> circle, turned;
  RandomStream random(24, 0);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector3d x(std::cos(k), std::sin(k), 0.01);
    circle.push_back({x, x.normalized()});
  }
  for (OrientedPoint p : points_on(diagonal(1, 1, 1, -1), 50, -1e3, random)) {
    turned.push_back({p.x, -p.n});
  }
  CHECK(vote(pencil, to_fit_points(circle), {}).empty());
  CHECK(vote(pencil, to_fit_points(turned), {}).empty());
  CHECK(vote(pencil, OrientedPointsf(), {}).empty());
}
