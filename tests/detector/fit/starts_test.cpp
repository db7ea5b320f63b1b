#include "fit/starts.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kSinglePrecision = 1e-3;

/// The least difference of a start from the truth; infinite if there is none.
double least_difference(const std::vector<PosedQuadric>& starts, const PosedQuadric& truth) {
  double least = INFINITY;
  for (const PosedQuadric& start : starts) {
    least = std::min(least, difference(start.matrix(), truth.matrix()));
  }
  return least;
}

/// The starts of the two families on which others build, as their fits would be without noise.
std::vector<FamilyFit> known_fits(Starts& starts) {
  std::vector<FamilyFit> known;
  for (const Family family : {Family::kRevolution, Family::kGeneral}) {
    for (const PosedQuadric& start : starts.of(family, {})) {
      FamilyFit& fit = known.emplace_back();
      fit.family = family;
      fit.posed = start;
    }
  }
  return known;
}

}  // namespace

TEST_CASE("one of the starts of a family is the surface on which exact points lie",
          "[fit][starts][law]") {
  RandomStream random(17, 0);
  for (const FamilyExample& example : family_examples()) {
    CAPTURE(example.name);
    for (int k = 0; k < 3; ++k) {
      const ExamplePoints data = make_points(example, 300, 0.0, random);
      Starts starts(data.points);
      const std::vector<FamilyFit> known = known_fits(starts);
      CHECK(least_difference(starts.of(example.family, known), data.truth) < kSinglePrecision);
    }
  }
}

TEST_CASE("families that build on others have no start without them", "[fit][starts]") {
  RandomStream random(18, 0);
  const ExamplePoints data = make_points(family_examples().back(), 300, 0.0, random);
  Starts starts(data.points);
  for (const Family family : {Family::kParaboloid, Family::kEllipticCylinder, Family::kParabolic}) {
    CHECK(starts.of(family, {}).empty());
  }
}

TEST_CASE("a fit of the round family starts the elliptic one with the same surface",
          "[fit][starts]") {
  RandomStream random(19, 0);
  const auto is_round = [](const FamilyExample& example) {
    return example.family == Family::kCylinder || example.family == Family::kParaboloid;
  };
  for (const FamilyExample& example : family_examples()) {
    if (!is_round(example)) continue;
    CAPTURE(example.name);
    const ExamplePoints data = make_points(example, 300, 0.0, random);
    Starts starts(data.points);
    FamilyFit round;
    round.family = example.family;
    round.posed = data.truth;
    const Family elliptic =
        example.family == Family::kCylinder ? Family::kEllipticCylinder : Family::kParabolic;
    const std::vector<PosedQuadric> list = starts.of(elliptic, {round});
    REQUIRE(list.size() == 1);
    CHECK(difference(list.front().matrix(), data.truth.matrix()) < 1e-12);
    // The elliptic family's fixed coefficient is one.
    const Eigen::Matrix4d& D = list.front().D;
    CHECK(std::abs(example.family == Family::kCylinder ? D(3, 3) : D(2, 3)) == Approx(1.0));
  }
}

TEST_CASE("points at one place have no start but finite ones", "[fit][starts][degenerate]") {
  Starts starts(to_fit_points(std::vector<OrientedPoint>(20, {{1, 2, 3}, {0, 0, 1}})));
  int count = 0;
  for (const FamilyExample& example : family_examples()) {
    for (const PosedQuadric& start : starts.of(example.family, {})) {
      CHECK(start.matrix().allFinite());
      ++count;
    }
  }
  CHECK(count > 0);
}
