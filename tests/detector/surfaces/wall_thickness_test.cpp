#include "surfaces/wall_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "detector/surfaces/cup.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the thickness of a wall that one fit hides is measured", "[walls]") {
  const double thickness = GENERATE(0.0, 0.002, 0.004);
  const SurfaceSamples samples = cup(thickness, 1);
  const Surface joint = cup_fit(samples);
  const SeenSides sides = sides_of(joint.Q, samples, joint.region);
  REQUIRE(sides.up.size() == kCupColumns * kCupRows);
  REQUIRE(sides.down.size() == kCupColumns * kCupRows);
  // The fit is between the walls.
  CHECK(joint.rms < std::max(2.0 * kCupNoise, 0.2 * thickness));
  const auto found = wall_thickness(joint, samples, sides);
  REQUIRE(found);
  CHECK(std::abs(found->value - thickness) < 0.15 * thickness + 2.0 * found->std);
  CHECK(found->std < 0.001);
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

TEST_CASE("a wall seen from one side has no known thickness", "[walls]") {
  const SurfaceSamples samples =
      cylinder_grid(kCupColumns, kCupRows, kCupRadius, kCupCell, kCupNoise, 3);
  const Surface surface = cup_fit(samples);
  CHECK_FALSE(wall_thickness(surface, samples, sides_of(surface.Q, samples, surface.region)));
}
