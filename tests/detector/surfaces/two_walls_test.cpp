#include "surfaces/two_walls.hpp"

#include <cmath>
#include <numeric>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kCupRadius = 0.04, kCupCell = 0.003, kCupNoise = 0.0003;
constexpr int kCupColumns = 25, kCupRows = 20;

/// The two walls of an upright cup that a camera on the x axis, somewhat above it, sees: the outer
/// one in front and the inner one behind.
SurfaceSamples cup(double thickness, std::uint64_t seed, double noise = kCupNoise) {
  return surface_grid(
      kCupColumns, 2 * kCupRows,
      [&](int i, int j) {
        const double angle = (i - 0.5 * (kCupColumns - 1)) * kCupCell / kCupRadius;
        const Eigen::Vector3d n(std::cos(angle), std::sin(angle), 0.0);
        const double r = j < kCupRows ? kCupRadius : -(kCupRadius - thickness);
        return OrientedPoint{r * n + (j % kCupRows) * kCupCell * Eigen::Vector3d::UnitZ(), n};
      },
      kCupCell, noise, seed);
}

Surface cup_fit(const SurfaceSamples& samples) {
  std::vector<int> all(static_cast<std::size_t>(samples.size()));
  std::iota(all.begin(), all.end(), 0);
  const auto surface = fit_surface(samples, std::move(all), {});
  REQUIRE(surface);
  return *surface;
}

double cup_radius(const Surface& surface) {
  REQUIRE(surface.fit.family == Family::kCylinder);
  return surface.local.scale * canonical_form(surface.fit.posed).dimensions.front().second;
}

}  // namespace

TEST_CASE("the thickness of a wall that one fit hides is measured", "[walls]") {
  const double thickness = GENERATE(0.0, 0.002, 0.004);
  const SurfaceSamples samples = cup(thickness, 1);
  const Surface joint = cup_fit(samples);
  const WallSides sides = sides_of(joint.Q, samples, joint.region);
  REQUIRE(sides.up.size() == kCupColumns * kCupRows);
  REQUIRE(sides.down.size() == kCupColumns * kCupRows);
  // The fit is between the walls.
  CHECK(joint.rms < std::max(2.0 * kCupNoise, 0.2 * thickness));
  const auto found = wall_thickness(joint, samples, sides);
  REQUIRE(found);
  CHECK(std::abs(found->value - thickness) < 0.15 * thickness + 2.0 * found->std);
  CHECK(found->std < 0.001);
}

TEST_CASE("the walls of a cup are two surfaces, a shell without thickness is one", "[walls]") {
  const SurfaceSamples thick = cup(0.004, 2), thin = cup(0.0, 2);
  const auto walls = two_walls(cup_fit(thick), thick, {});
  REQUIRE(walls);
  CHECK(std::abs(cup_radius(walls->up) - kCupRadius) < 0.001);
  CHECK(std::abs(cup_radius(walls->down) - (kCupRadius - 0.004)) < 0.001);
  CHECK_FALSE(two_walls(cup_fit(thin), thin, {}));
}

TEST_CASE("noise does not change the measured thickness of a wall", "[walls]") {
  const double thickness = 0.003, noise = GENERATE(0.0005, 0.001, 0.002);
  constexpr int kCups = 8;
  double mean = 0.0;
  for (int seed = 1; seed <= kCups; ++seed) {
    const SurfaceSamples samples = cup(thickness, static_cast<std::uint64_t>(seed), noise);
    const Surface joint = cup_fit(samples);
    const auto found = wall_thickness(joint, samples, sides_of(joint.Q, samples, joint.region));
    REQUIRE(found);
    mean += found->value / kCups;
  }
  // The mean of eight cups is off by a third as much as that of one.
  CAPTURE(noise, mean);
  CHECK(std::abs(mean - thickness) < 0.3 * noise);
}

TEST_CASE("a wall whose thickness the noise hides is taken for that of a cup", "[walls]") {
  // With so much noise a shell without thickness may measure as much.
  const SurfaceSamples samples = cup(0.003, GENERATE(1, 2, 3), 0.002);
  const Surface joint = cup_fit(samples);
  const auto found = wall_thickness(joint, samples, sides_of(joint.Q, samples, joint.region));
  REQUIRE(found);
  CAPTURE(found->value, found->std);
  CHECK(found->std > 0.002);
  CHECK(two_walls(joint, samples, {}));
}

TEST_CASE("a wall seen from one side has no known thickness", "[walls]") {
  const SurfaceSamples samples =
      cylinder_grid(kCupColumns, kCupRows, kCupRadius, kCupCell, kCupNoise, 3);
  const Surface surface = cup_fit(samples);
  CHECK_FALSE(wall_thickness(surface, samples, sides_of(surface.Q, samples, surface.region)));
  CHECK_FALSE(two_walls(surface, samples, {}));
}
