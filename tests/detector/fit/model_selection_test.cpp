#include "fit/model_selection.hpp"

#include <array>
#include <cmath>

#include "fit/family_spec.hpp"
#include "support/catch.hpp"
#include "support/quadric_points.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::array kAll = {
    Family::kPlane,      Family::kSphere,     Family::kCylinder,         Family::kCone,
    Family::kRevolution, Family::kParaboloid, Family::kEllipticCylinder, Family::kParabolic};

std::optional<Selection> select(const OrientedPointsf& points, const SelectionOptions& options) {
  FamilyFits fits(points);
  const auto general = fits.fit(Family::kGeneral, 15);
  if (!general) return std::nullopt;
  return fits.select(kAll, *general, options);
}

}  // namespace

TEST_CASE("the simplest family that explains the points is selected", "[selection]") {
  RandomStream random(51, 0);
  SelectionOptions options;
  options.iterations = 15;
  for (const FamilyExample& example : family_examples()) {
    // A general fit may double a plane, where its first-order distance is half the true one: such
    // fits are refused later, as thin.
    if (example.family == Family::kPlane) continue;
    int right = 0;
    constexpr int kTrials = 20;
    for (int k = 0; k < kTrials; ++k) {
      const auto selection = select(make_points(example, 400, 0.01, random).points, options);
      REQUIRE(selection);
      right += selection->best.family == example.family;
    }
    CAPTURE(example.name, right);
    CHECK(right >= kTrials - 3);
  }
}

TEST_CASE("BIC is n ln(rss / N) + k ln n with the effective size n", "[selection]") {
  SelectionOptions options;
  options.effective_share = 0.1;
  CHECK(bic(4.0, 1000, 6, options) == Approx(100 * std::log(0.004) + 6 * std::log(100.0)));
  // One parameter more pays if it lowers the residual by more than n^(-1/n).
  const double factor = std::pow(100.0, -1.0 / 100.0);
  CHECK(bic(4.0 * factor * 0.999, 1000, 7, options) < bic(4.0, 1000, 6, options));
  CHECK(bic(4.0 * factor * 1.001, 1000, 7, options) > bic(4.0, 1000, 6, options));
}

TEST_CASE("what lies within the common noise earns no parameter", "[selection]") {
  SelectionOptions options;
  options.effective_share = 0.1;
  options.common_noise = 0.1;
  CHECK(bic(4.0, 1000, 6, options) == Approx(100 * std::log(0.014) + 6 * std::log(100.0)));
  // A residual of half the size is worth a parameter without the common noise, but not with it.
  CHECK(bic(0.4, 1000, 7, options) > bic(0.8, 1000, 6, options));
  options.common_noise = 0.0;
  CHECK(bic(0.4, 1000, 7, options) < bic(0.8, 1000, 6, options));
}

TEST_CASE("the selected fit has the least BIC of all that were tried", "[selection]") {
  RandomStream random(52, 0);
  for (const FamilyExample& example : family_examples()) {
    const SelectionOptions options;
    const auto selection = select(make_points(example, 300, 0.01, random).points, options);
    REQUIRE(selection);
    for (const FamilyFit& fit : selection->fits) {
      CHECK(selection->bic <= bic(fit, options));
    }
  }
}

TEST_CASE("types that fewer objects have need more odds, by their prior", "[selection]") {
  FamilyFit fit;
  fit.rss = 4.0;
  fit.points = 1000;
  const SelectionOptions options;
  const auto over = [&](const Eigen::Matrix4d& D) {
    fit.posed.D = D;
    return bic(fit, options) - bic(4.0, 1000, family_spec(fit.family).dof, options);
  };
  CHECK(over(diagonal(1, 1, 1, -1)) == Approx(0.0).margin(1e-12));
  CHECK(over(diagonal(1, 1, 0, -1)) == Approx(0.0).margin(1e-12));
  CHECK(over(diagonal(1, 2, 3, -1)) == Approx(3.0));
  CHECK(over(diagonal(1, 2, -3, -1)) == Approx(3.0));
  CHECK(over(diagonal(1, 2, -3, 1)) == Approx(4.0));
  CHECK(over(diagonal(1, -2, 0, -1)) == Approx(4.0));
}

TEST_CASE("fewer independent measurements argue for simpler types", "[selection]") {
  RandomStream random(53, 0);
  // Semi-axes 5 % apart under 2 % noise: seen with many measurements only.
  const FamilyExample example{Family::kEllipticCylinder, "", diagonal(1, 1.1, 0, -0.5)};
  const OrientedPointsf points = make_points(example, 600, 0.02, random).points;
  SelectionOptions options;
  options.iterations = 15;
  options.effective_share = 1.0;
  CHECK(select(points, options)->best.family == Family::kEllipticCylinder);
  options.effective_share = 0.01;
  CHECK(family_spec(select(points, options)->best.family).dof <= 5);
}

TEST_CASE("too few points have no fit", "[selection][degenerate]") {
  RandomStream random(54, 0);
  const OrientedPointsf points = make_points(family_examples()[1], 3, 0.0, random).points;
  CHECK_FALSE(fit_family(points, Family::kGeneral, 5));
  CHECK_FALSE(fit_family(points, Family::kSphere, 5));
}
