#include "fit/model_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/family_spec.hpp"
#include "fit/geometric_fit.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// A restricted fit has at least this share of the residual of the general one, which is not fully
// converged.
constexpr double kLeastShare = 0.95;

double effective_size(int size, const SelectionOptions& options) {
  return std::max(2.0, options.effective_share * size);
}

/// The inverse of bic(): the sum of squares at which a fit reaches it.
double rss_for(double bic, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  const double variance = std::exp((bic - dof * std::log(n)) / n);
  return size * std::max(0.0, variance - options.common_noise * options.common_noise);
}

}  // namespace

double bic(double rss, int size, int dof, const SelectionOptions& options) {
  const double n = effective_size(size, options);
  const double variance = rss / size + options.common_noise * options.common_noise + 1e-18;
  return n * std::log(variance) + dof * std::log(n);
}

double bic(const FamilyFit& fit, const SelectionOptions& options) {
  return bic(fit.rss, fit.points, family_spec(fit.family).dof, options) -
         2.0 * log_prior(canonical_form(fit.posed).type);
}

/// Refines the best of a family's starts.
std::optional<FamilyFit> FamilyFits::fit_from(Family family, const std::vector<FamilyFit>& known,
                                              int iterations, double wanted) {
  const PosedQuadric* best = nullptr;
  double least = 0.0;
  const std::vector<PosedQuadric> list = starts_.of(family, known);
  for (const PosedQuadric& start : list) {
    double rss = 0.0;
    if (list.size() > 1 || family == Family::kPlane) {
      sums_.evaluate(start.matrix());
      rss = sums_.squares();
    }
    if (!best || rss < least) best = &start, least = rss;
  }
  if (!best) return std::nullopt;
  // The closed form of a plane minimises the distances themselves.
  if (family == Family::kPlane) {
    return FamilyFit{family, *best, least, static_cast<int>(sums_.points())};
  }
  return refine(&sums_, family, *best, iterations, wanted);
}

std::optional<FamilyFit> FamilyFits::fit(Family family, int iterations) {
  return fit_from(family, {}, iterations, std::numeric_limits<double>::infinity());
}

Selection FamilyFits::select(std::span<const Family> families, const FamilyFit& general,
                             const SelectionOptions& options) {
  const int size = general.points;
  Selection selection;
  selection.best = general;
  selection.bic = bic(general, options);
  selection.fits.push_back(general);
  for (const Family family : families) {
    // The family cannot become the best, so its fit is skipped.
    const int dof = family_spec(family).dof;
    if (bic(kLeastShare * general.rss, size, dof, options) >= selection.bic) continue;
    const double wanted = rss_for(selection.bic, size, dof, options);
    std::optional<FamilyFit> fit = fit_from(family, selection.fits, options.iterations, wanted);
    if (!fit) continue;
    const double value = bic(*fit, options);
    if (value < selection.bic) {
      selection.best = *fit;
      selection.bic = value;
    }
    selection.fits.push_back(std::move(*fit));
  }
  return selection;
}

std::optional<FamilyFit> fit_family(const OrientedPointsf& points, Family family, int iterations) {
  return FamilyFits(points).fit(family, iterations);
}

}  // namespace quadrille
