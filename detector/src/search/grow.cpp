#include "search/grow.hpp"

#include <cmath>

#include "fit/model_selection.hpp"
#include "samples/inliers.hpp"

namespace quadrille {
namespace {

// Steps of a refit; the final fit of the surface takes more.
constexpr int kIterations = 4;
// Assumed share of independent samples; while a region grows, measuring their correlation is not
// worth the time.
constexpr double kEffectiveShare = 0.1;
// Growing ends with a round that changes the region by less than this share.
constexpr double kMinChange = 0.03;
// The family is selected anew when the region has grown or shrunk by this factor.
constexpr double kReselectionGrowth = 1.25;

/// Refits a candidate to its region, with its present family or with the one that explains the
/// region best; returns false if there is no fit.
bool refit(const SurfaceSamples& samples, const GrowOptions& options, bool select,
           Candidate* candidate) {
  const Normalisation local = normalisation_of(samples, candidate->region);
  const OrientedPointsf points = fit_points(samples, candidate->region, local, options.fit_points);
  FamilyFits fits(points);
  std::optional<FamilyFit> best =
      fits.fit(select ? Family::kGeneral : candidate->family, kIterations);
  if (!best) return false;
  if (select) {
    SelectionOptions selection_options;
    selection_options.effective_share = kEffectiveShare;
    best = fits.select(options.families, *best, selection_options).best;
  }
  candidate->Q = local.to_frame(best->posed.matrix()).normalized();
  candidate->family = best->family;
  candidate->rms = local.scale * std::sqrt(best->rss / static_cast<double>(points.size()));
  return true;
}

}  // namespace

std::optional<Candidate> grow(const SurfaceSamples& samples, const Quadric& hypothesis,
                              std::span<const int> start, const Mask& free,
                              const InlierTest& inlier, const GrowOptions& options, Marks* seen) {
  Candidate candidate;
  candidate.Q = hypothesis;
  candidate.region = connected_inliers(samples, start, candidate.Q, inlier, free, seen);
  const auto enough = [&] {
    return static_cast<int>(candidate.region.size()) >= options.min_samples;
  };
  const bool choice = options.families.size() > 1;
  if (!choice) candidate.family = options.families[0];
  double chosen_at = 0.0;  // size of the region when the family was last selected
  for (int round = 0; round < options.rounds; ++round) {
    if (!enough()) return std::nullopt;
    const double now = static_cast<double>(candidate.region.size());
    const bool select =
        choice && (now > kReselectionGrowth * chosen_at || now * kReselectionGrowth < chosen_at);
    if (select) chosen_at = now;
    if (!refit(samples, options, select, &candidate)) return std::nullopt;
    std::vector<int> next =
        connected_inliers(samples, candidate.region, candidate.Q, inlier, free, seen);
    const double size = static_cast<double>(candidate.region.size());
    const bool settled = std::abs(static_cast<double>(next.size()) - size) < kMinChange * size;
    candidate.region = std::move(next);
    if (settled && round > 0) break;
  }
  if (!enough()) return std::nullopt;
  return candidate;
}

}  // namespace quadrille
