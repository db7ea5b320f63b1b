#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "support/catch.hpp"
#include "support/surface_grid.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille::test {

inline constexpr double kCupRadius = 0.04, kCupCell = 0.003, kCupNoise = 0.0003;
inline constexpr int kCupColumns = 25, kCupRows = 20;

/// The two walls of an upright cup that a camera on the x axis, somewhat above it, sees: the outer
/// one in front and the inner one behind.
inline SurfaceSamples cup(double thickness, std::uint64_t seed, double noise = kCupNoise) {
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

inline Surface cup_fit(const SurfaceSamples& samples) {
  std::vector<int> all(static_cast<std::size_t>(samples.size()));
  std::iota(all.begin(), all.end(), 0);
  const auto surface = fit_surface(samples, std::move(all), {});
  REQUIRE(surface);
  return *surface;
}

}  // namespace quadrille::test
