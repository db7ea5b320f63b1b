#include "surfaces/join.hpp"

#include <algorithm>

#include "fit/model_selection.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// Largest distance between the centres of two surfaces that meet, over the sum of their sizes. The
// size is a root mean square, so the ends are up to about twice as far away.
constexpr double kMaxApart = 2.5;
// The residual of a joint fit may exceed the worse of the two by this factor, since it has fewer
// parameters.
constexpr double kMaxRmsGrowth = 1.25;

double bic_of(const Surface& surface, const SurfaceSamples& samples, double effective_size) {
  FamilyFit whole = surface.fit;
  whole.points = static_cast<int>(surface.region.size());
  // Residuals below the noise do not make a fit better.
  const double rms = std::max(surface.rms, mean_sigma(samples, surface.region));
  whole.rss = rms * rms * whole.points;
  SelectionOptions selection;
  selection.effective_share = effective_size / whole.points;
  return bic(whole, selection);
}

}  // namespace

bool may_meet(const Normalisation& a, const Normalisation& b) {
  return (a.centre - b.centre).norm() < kMaxApart * (a.scale + b.scale);
}

std::optional<Surface> join(const Surface& a, const Surface& b, const SurfaceSamples& samples,
                            const AggregateOptions& options) {
  if (is_flat(a) != is_flat(b) || !may_meet(a.local, b.local)) return std::nullopt;
  std::vector<int> all = b.region;
  all.insert(all.end(), a.region.begin(), a.region.end());
  std::optional<Surface> joint = fit_surface(samples, std::move(all), options);
  if (!joint || is_flat(*joint) != is_flat(b) || is_thin(*joint, samples) ||
      !(joint->rms < kMaxRmsGrowth * std::max({a.rms, b.rms, samples.view_shift})) ||
      !(bic_of(*joint, samples, a.effective_size + b.effective_size) <
        bic_of(a, samples, a.effective_size) + bic_of(b, samples, b.effective_size))) {
    return std::nullopt;
  }
  return joint;
}

}  // namespace quadrille
