#include "surfaces/two_walls.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "fit/geometric_fit.hpp"
#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Least and largest thickness of the walls of cups and bowls [m]: thin metal or plastic counts as
// one surface, and thick earthenware has 6 to 7 mm.
constexpr double kMinThickness = 0.001, kMaxThickness = 0.008;
// Number of steps of the fit, which starts near its end.
constexpr int kThicknessSteps = 4;

/// True if a wall is known to have a thickness that walls of vessels have.
bool is_thick(const MeasuredThickness& thickness) {
  return thickness.value > std::max(kMinThickness, thickness.std) &&
         thickness.value < kMaxThickness;
}

OrientedPointsf points_of_wall(const Surface& surface, const SurfaceSamples& samples,
                               std::span<const int> some) {
  return fit_points(samples, some, surface.local, static_cast<int>(some.size()));
}

}  // namespace

WallSides sides_of(const Quadric& quadric, const SurfaceSamples& samples,
                   std::span<const int> region) {
  const Eigen::Matrix4f Q = quadric.matrix().cast<float>();
  WallSides sides;
  for (const int i : region) {
    const Eigen::Vector3f h = (Q * samples.raw[i].homogeneous()).head<3>();
    (h.dot(samples.n[i]) > 0.0f ? sides.up : sides.down).push_back(i);
  }
  return sides;
}

std::optional<MeasuredThickness> wall_thickness(const Surface& surface,
                                                const SurfaceSamples& samples,
                                                const WallSides& sides) {
  if (sides.up.empty() || sides.down.empty()) return std::nullopt;
  const OrientedPointsf whole = points_of_wall(surface, samples, surface.region);
  const OrientedPointsf down = points_of_wall(surface, samples, sides.down);
  const auto size = static_cast<double>(whole.size()), n = static_cast<double>(down.size());
  DistanceSums<float> sums(whole);
  FamilyFit fit = surface.fit;
  double t = 0.0, m = 0.0, left = 0.0;
  for (int step = 0; step < kThicknessSteps; ++step) {
    const StepEquations all = step_equations(&sums, fit.family, fit.posed);
    const Eigen::VectorXd c = information(down, fit).Jt1;
    const Eigen::Matrix4f Q = fit.posed.matrix().cast<float>();
    double sum = 0.0;
    for (const auto& x : down.points.colwise()) sum += distance_to(Q, x);
    const Eigen::LDLT<Eigen::MatrixXd> A(all.A);
    const Eigen::VectorXd b = all.b + t * c;
    m = n - c.dot(A.solve(c));
    if (!(m > 0.0)) return std::nullopt;
    left = all.rss + 2.0 * t * sum + n * t * t;
    const double change = -(sum + n * t - c.dot(A.solve(b))) / m;
    const Eigen::VectorXd move = -A.solve(b + change * c);
    if (!move.allFinite() || !std::isfinite(change)) return std::nullopt;
    fit.posed = moved(fit.family, fit.posed, move);
    t += change;
  }
  // Residuals below the noise are chance.
  const double noise = mean_sigma(samples, surface.region) / surface.local.scale;
  const double variance = std::max(noise * noise, left / size) * size / surface.effective_size;
  return MeasuredThickness{surface.local.scale * t, surface.local.scale * std::sqrt(variance / m)};
}

std::optional<TwoWalls> two_walls(const Surface& surface, const SurfaceSamples& samples,
                                  const AggregateOptions& options) {
  if (is_flat(surface)) return std::nullopt;
  WallSides sides = sides_of(surface.Q, samples, surface.region);
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
