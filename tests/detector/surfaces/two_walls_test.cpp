#include "surfaces/two_walls.hpp"

#include <cmath>

#include "detector/surfaces/cup.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/wall_thickness.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

double cup_radius(const Surface& surface) {
  REQUIRE(surface.fit.family == Family::kCylinder);
  return surface.local.scale * canonical_form(surface.fit.posed).dimensions.front().second;
}

}  // namespace

TEST_CASE("the walls of a cup are two surfaces, a shell without thickness is one", "[walls]") {
  const SurfaceSamples thick = cup(0.004, 2), thin = cup(0.0, 2);
  const auto walls = two_walls(cup_fit(thick), thick, {});
  REQUIRE(walls);
  CHECK(std::abs(cup_radius(walls->up) - kCupRadius) < 0.001);
  CHECK(std::abs(cup_radius(walls->down) - (kCupRadius - 0.004)) < 0.001);
  CHECK_FALSE(two_walls(cup_fit(thin), thin, {}));
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

TEST_CASE("a wall seen from one side is one surface", "[walls]") {
  const SurfaceSamples samples =
      cylinder_grid(kCupColumns, kCupRows, kCupRadius, kCupCell, kCupNoise, 3);
  CHECK_FALSE(two_walls(cup_fit(samples), samples, {}));
}
