#include "surfaces/evidence/two_planes.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int kSide = 30;
constexpr double kCell = 0.004;

/// A roof: two half planes that meet along z with that angle between their normals [rad].
SurfaceSamples roof(double angle, double noise) {
  return surface_grid(
      kSide, kSide,
      [&](int i, int j) {
        const double s = (i - 0.5 * (kSide - 1)) * kCell;
        const double a = s < 0 ? -0.5 * angle : 0.5 * angle;
        const Eigen::Vector3d n(std::cos(a), std::sin(a), 0.0);
        const Eigen::Vector3d along(-std::sin(a), std::cos(a), 0.0);
        return OrientedPoint{s * along + j * kCell * Eigen::Vector3d::UnitZ(), n};
      },
      kCell, noise, 5);
}

}  // namespace

TEST_CASE("a roof without noise is two planes exactly", "[two_planes]") {
  for (const double angle : {0.3, 1.0, M_PI_2}) {
    const SurfaceSamples samples = roof(angle, 0.0);
    CHECK(two_planes_rss(samples, all_of(samples)) < 1e-10);
  }
}

TEST_CASE("the residual of two noisy planes is the noise", "[two_planes]") {
  const double noise = 0.001;
  const SurfaceSamples samples = roof(1.0, noise);
  const double rss = two_planes_rss(samples, all_of(samples));
  CHECK(rss == Approx(kSide * kSide * noise * noise).epsilon(0.15));
}

TEST_CASE("a cylinder's residual is what two tangent strips leave over", "[two_planes]") {
  // Each plane takes an arc of half angle c = b / 2. The arc's height R θ² / 2 over its best chord
  // has the variance R² / 4 (E θ⁴ - (E θ²)²) = R² c⁴ / 45 = R² b⁴ / 720.
  const double radius = 0.08;
  const SurfaceSamples samples = cylinder_grid(kSide, kSide, radius, kCell, 0.0, 1);
  const double b = 0.5 * kSide * kCell / radius;
  const double expected = samples.size() * radius * radius * std::pow(b, 4) / 720.0;
  const double rss = two_planes_rss(samples, all_of(samples));
  CHECK(rss == Approx(expected).epsilon(0.2));
}
