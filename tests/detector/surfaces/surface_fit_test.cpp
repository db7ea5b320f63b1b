#include "surfaces/surface_fit.hpp"

#include "detector/pipe.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {}  // namespace

TEST_CASE("a region is fitted by the family that it is of, and a bent one is no plane",
          "[surface_fit]") {
  const SurfaceSamples samples = pipe();
  const auto surface = fit_surface(samples, all_of(samples), {});
  REQUIRE(surface);
  CHECK(surface->fit.family == Family::kCylinder);
  CHECK(surface->rms == Approx(0.0005).epsilon(0.2));
  CHECK(surface->effective_size <= AggregateOptions().effective_size);
  CHECK_FALSE(fit_plane(samples, all_of(samples), {}));
}
