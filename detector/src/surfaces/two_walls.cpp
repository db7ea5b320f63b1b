#include "surfaces/two_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfaces/surface_fit.hpp"
#include "surfaces/usual_wall.hpp"
#include "surfaces/wall_thickness.hpp"

namespace quadrille {
namespace {

// Number of vessels with such walls for each that counts as one surface, of thin metal or plastic.
constexpr double kVesselOdds = 3.0;

/// Logarithm of the density of a normal distribution, but for a constant.
double log_normal(double value, double mean, double variance) {
  const double d = value - mean;
  return -0.5 * (d * d / variance + std::log(variance));
}

/// True if a wall is more likely that of a vessel than a thin shell, by Bayes' theorem. Noise and
/// the smoothing of a sensor may hide a thickness, or make it negative.
bool is_thick(const MeasuredThickness& thickness) {
  const double variance = thickness.std * thickness.std;
  const double of_vessel =
      log_normal(thickness.value, kUsualThickness, variance + kThicknessSpread * kThicknessSpread);
  const double of_shell = log_normal(thickness.value, 0.0, variance);
  return of_vessel + std::log(kVesselOdds) > of_shell &&
         thickness.value - thickness.std < kMaxThickness;
}

}  // namespace

std::optional<TwoWalls> two_walls(const Surface& surface, const SurfaceSamples& samples,
                                  const AggregateOptions& options) {
  if (is_flat(surface)) return std::nullopt;
  SeenSides sides = sides_of(surface.Q, samples, surface.region);
  const std::size_t smaller = std::min(sides.up.size(), sides.down.size());
  if (smaller < static_cast<std::size_t>(options.min_samples)) return std::nullopt;
  const std::optional<MeasuredThickness> thickness = wall_thickness(surface, samples, sides);
  if (!thickness || !is_thick(*thickness)) return std::nullopt;
  std::optional<Surface> up = fit_surface(samples, std::move(sides.up), options);
  std::optional<Surface> down = fit_surface(samples, std::move(sides.down), options);
  const auto is_wall = [&](const std::optional<Surface>& wall) {
    return wall && !is_flat(*wall) && !is_thin(*wall, samples);
  };
  if (!is_wall(up) || !is_wall(down)) return std::nullopt;
  return TwoWalls{std::move(*up), std::move(*down)};
}

}  // namespace quadrille
