#include "surfaces/surface.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr double kSurfaceRadius = 0.04;

/// A surface on all samples, in local coordinates of scale one about the origin.
Surface surface_on(const SurfaceSamples& samples, const Eigen::Matrix4d& D) {
  Surface surface;
  surface.region = all_of(samples);
  surface.fit.posed.D = D;
  surface.Q = Quadric(D);
  surface.local.scale = 1.0;
  return surface;
}

}  // namespace

TEST_CASE("the distance from a wider cylinder is the difference of the radii", "[surface]") {
  const SurfaceSamples samples = cylinder_grid(21, 31, kSurfaceRadius, 0.004, 0.0, 1);
  const double wider = 1.01 * kSurfaceRadius;
  const Surface surface = surface_on(samples, diagonal(1, 1, 0, -wider * wider));
  CHECK(rms_distance(surface.Q, samples, all_of(samples)) ==
        Approx(0.01 * kSurfaceRadius).epsilon(0.02));
}

TEST_CASE("a surface is thin if its sides lie within three deviations", "[surface]") {
  const SurfaceSamples samples = cylinder_grid(21, 31, kSurfaceRadius, 0.004, 0.0005, 1);
  const double sigma = mean_sigma(samples, all_of(samples));
  const auto slab = [&](double half) { return diagonal(1, 1 / (half * half), 0, -1); };
  CHECK(is_thin(surface_on(samples, slab(2.9 * sigma)), samples));
  CHECK_FALSE(is_thin(surface_on(samples, slab(3.1 * sigma)), samples));
}

TEST_CASE("a hyperbolic cylinder within one cell is an edge", "[surface]") {
  const SurfaceSamples samples = cylinder_grid(21, 31, kSurfaceRadius, 0.004, 0.0, 1);
  const double cell = samples.cell.front();
  REQUIRE(cell > 3.0 * mean_sigma(samples, all_of(samples)));
  const auto fold = [](double a) { return diagonal(1 / (a * a), -1, 0, -1); };
  CHECK(is_thin(surface_on(samples, fold(0.9 * cell)), samples));
  CHECK_FALSE(is_thin(surface_on(samples, fold(1.1 * cell)), samples));
}
