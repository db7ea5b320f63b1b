#include "surfaces/surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/model_selection.hpp"
#include "surfaces/evidence/effective_share.hpp"

namespace quadrille {
namespace {

// Number of steps of a fit, after which nearly all have converged.
constexpr int kIterations = 6;

}  // namespace

void set_fit(Surface* surface, FamilyFit fit) {
  surface->Q = surface->local.to_frame(fit.posed.matrix()).normalized();
  surface->rms = surface->local.scale * std::sqrt(fit.rss / fit.points);
  surface->fit = std::move(fit);
}

Surface surface_of(std::vector<int> region, const Normalisation& local, FamilyFit fit,
                   const OrientedPointsf& points) {
  Surface surface;
  surface.local = local;
  surface.information = information(points, fit);
  set_fit(&surface, std::move(fit));
  surface.region = std::move(region);
  return surface;
}

std::optional<Surface> fit_surface(const SurfaceSamples& samples, std::vector<int> region,
                                   const AggregateOptions& options) {
  const Normalisation local = normalisation_of(samples, region);
  const OrientedPointsf points = fit_points(samples, region, local, options.fit_points);
  FamilyFits fits(points);
  const std::optional<FamilyFit> general = fits.fit(Family::kGeneral, kIterations);
  if (!general) return std::nullopt;
  const double share =
      std::min(effective_share(samples, region, local.to_frame(general->posed.matrix())),
               options.effective_share);
  const double effective_size =
      std::min(options.effective_size, share * static_cast<double>(region.size()));
  SelectionOptions selection;
  selection.iterations = kIterations;
  selection.effective_share = effective_size / static_cast<double>(points.size());
  const double common_noise = samples.common_noise * mean_sigma(samples, region) / local.scale;
  selection.common_noise = std::hypot(common_noise, kFlawShare);
  FamilyFit best = fits.select(options.families, *general, selection).best;
  Surface surface = surface_of(std::move(region), local, std::move(best), points);
  surface.effective_size = effective_size;
  return surface;
}

std::optional<Surface> fit_plane(const SurfaceSamples& samples, std::vector<int> region,
                                 const AggregateOptions& options) {
  const Normalisation local = normalisation_of(samples, region);
  const OrientedPointsf points = fit_points(samples, region, local, options.fit_points);
  std::optional<FamilyFit> fit = fit_family(points, Family::kPlane, kIterations);
  if (!fit) return std::nullopt;
  Surface surface = surface_of(std::move(region), local, std::move(*fit), points);
  if (surface.rms > options.max_residual_plane * mean_sigma(samples, surface.region)) {
    return std::nullopt;
  }
  surface.effective_size = std::min(
      options.effective_size, options.effective_share * static_cast<double>(surface.region.size()));
  return surface;
}

}  // namespace quadrille
