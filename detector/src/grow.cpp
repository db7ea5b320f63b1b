#include "quadrille/detector/grow.hpp"

#include <cmath>

#include "quadrille/detector/model_selection.hpp"

namespace quadrille {
namespace {

constexpr int kIterations = 4;
// While a region grows, its samples' correlation is not worth measuring.
constexpr double kEffectiveShare = 0.1;
// A round that changes the region by less than this share is the last.
constexpr double kSettled = 0.03;

/// Fits a region in place; false if it has no fit.
bool refit(const SurfaceSamples& samples, const GrowOptions& options, Candidate* candidate) {
  const Normalisation local = normalisation_of(samples, candidate->region);
  const FitPoints points = fit_points(samples, candidate->region, local, options.fit_points);
  const bool one = options.families.size() == 1;
  std::optional<FamilyFit> best =
      fit_family(points, one ? options.families[0] : Family::kGeneral, kIterations);
  if (!best) return false;
  if (!one) {
    SelectionOptions selection_options;
    selection_options.effective_share = kEffectiveShare;
    best = select_family(points, options.families, *best, selection_options).best;
  }
  candidate->Q = local.to_frame(best->posed.matrix()).normalized();
  candidate->family = best->family;
  candidate->rms = local.scale * std::sqrt(best->rss / static_cast<double>(points.size()));
  return true;
}

}  // namespace

std::optional<Candidate> grow(const SurfaceSamples& samples, const Quadric& hypothesis,
                              std::span<const int> start, const std::vector<char>& free,
                              const InlierTest& inlier, const GrowOptions& options) {
  Candidate candidate;
  candidate.Q = hypothesis;
  candidate.region = connected_inliers(samples, start, candidate.Q, inlier, free);
  const auto enough = [&] {
    return static_cast<int>(candidate.region.size()) >= options.least_samples;
  };
  for (int round = 0; round < options.rounds; ++round) {
    if (!enough() || !refit(samples, options, &candidate)) return std::nullopt;
    std::vector<int> next = connected_inliers(samples, candidate.region, candidate.Q, inlier, free);
    const double size = static_cast<double>(candidate.region.size());
    const bool settled = std::abs(static_cast<double>(next.size()) - size) < kSettled * size;
    candidate.region = std::move(next);
    if (settled && round > 0) break;
  }
  if (!enough()) return std::nullopt;
  return candidate;
}

}  // namespace quadrille
