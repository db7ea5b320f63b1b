#include "variants/draw_variant.hpp"

#include <cmath>
#include <numeric>

#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

Voters voters_of(const OrientedPointsf& points) {
  Voters voters{points, std::vector<int>(static_cast<std::size_t>(points.size())), 0.05f, {}};
  std::iota(voters.samples.begin(), voters.samples.end(), 100);
  return voters;
}

/// The best of some draws.
std::pair<double, double> best_drawn(VariantBasis basis, int draws, const Voters& voters,
                                     RandomStream& random) {
  std::pair<double, double> best(1e9, 0.0);
  for (int k = 0; k < draws; ++k) {
    for (const Eigen::Matrix4d& Q : draw_variant({.basis = basis}, voters, random)) {
      best = std::min(best, mean_agreement(Q, voters.points));
    }
  }
  return best;
}

constexpr VariantBasis kGeneral[] = {VariantBasis::kThreePoints, VariantBasis::kFourPoints,
                                     VariantBasis::kNinePoints, VariantBasis::kTwoPoints};

}  // namespace

TEST_CASE("general bases find any quadric, on the side of its normals", "[variants]") {
  RandomStream random(98, 0);
  for (const FamilyExample& example : family_examples()) {
    if (example.family == Family::kPlane) continue;
    const Voters voters = voters_of(to_fit_points(points_on(example.D, 200, example.low, random)));
    for (const VariantBasis basis : kGeneral) {
      CAPTURE(example.name, static_cast<int>(basis));
      const auto [distance, cosine] = best_drawn(basis, 40, voters, random);
      CHECK(distance < 0.05);
      CHECK(cosine > 0.9);
    }
  }
}

TEST_CASE("the variant of the default draws what the detector draws", "[variants][law]") {
  RandomStream random(105, 0);
  const Voters voters =
      voters_of(to_fit_points(points_on(diagonal(1, 1, 1, -0.81), 100, 0.0, random)));
  RandomStream here(106, 0), there(106, 0);
  for (int k = 0; k < 100; ++k) {
    CHECK(draw_variant({}, voters, here) ==
          draw_hypotheses(BasisKind::kThreePoints, voters.points, voters.vote, there));
  }
}

TEST_CASE("no basis is drawn from points that coincide", "[variants][hostile]") {
  OrientedPointsf points(20);
  points.points.colwise() = Eigen::Vector3f(0.1f, 0.2f, 0.3f);
  points.normals.colwise() = Eigen::Vector3f::UnitX();
  RandomStream random(99, 0);
  for (const VariantBasis basis : kGeneral) {
    CHECK(draw_variant({.basis = basis}, voters_of(points), random).empty());
  }
}

TEST_CASE("known bases are refused, and no other changes", "[variants][triplets]") {
  RandomStream random(101, 0);
  Voters voters = voters_of(to_fit_points(points_on(diagonal(1, 1, 1, -0.81), 12, -1e3, random)));
  voters.vote.min_height = 0.0;
  TripletSet seen;
  const auto draw_many = [&](TripletSet* known) {
    RandomStream draws(102, 0);
    int drawn = 0;
    for (int k = 0; k < 5000; ++k) drawn += !draw_variant({}, voters, draws, known).empty();
    return drawn;
  };
  const int without = draw_many(nullptr);
  CHECK(without > 1000);
  // Twelve points form 220 triplets.
  const int with = draw_many(&seen);
  CHECK(with > 50);
  CHECK(with <= 220);
  CHECK(seen.size() <= 220);
  CHECK(static_cast<int>(seen.size() + seen.repeats()) >= without);
  CHECK(draw_many(&seen) == 0);
  // A basis is known by its samples, so the same points under other numbers are drawn anew.
  for (int& sample : voters.samples) sample += 1000;
  CHECK(draw_many(&seen) == with);
}
