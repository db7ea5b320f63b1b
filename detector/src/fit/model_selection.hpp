#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/geometric_fit.hpp"

namespace quadrille {

struct SelectionOptions {
  /// Independent measurements per point: neighbours share their noise.
  double effective_share = 0.25;
  /// Standard deviation of the noise that all points have in common, in their unit: a residual
  /// below it earns no credit.
  double common_noise = 0.0;
  /// Steps of the geometric fit.
  int iterations = 6;
};

/// The fit that the Bayesian information criterion prefers, n ln(rss / N + c²) + k ln n with N
/// points, n the effective sample size, k the degrees of freedom and c the common noise, less twice
/// the type's log_prior(): the simplest type that explains the points.
struct Selection {
  FamilyFit best;
  double bic = 0.0;
  /// Fits of all families tried.
  std::vector<FamilyFit> fits;
};

/// BIC of a fit to `size` points, without the prior.
double bic(double rss, int size, int dof, const SelectionOptions& options);

/// BIC of a fit, with the prior of its type.
double bic(const FamilyFit& fit, const SelectionOptions& options);

/// The best fit of one family from its own closed-form starts; nullopt if there is none, as for
/// the paraboloids and the elliptic cylinder, which start from other families' fits.
std::optional<FamilyFit> fit_family(const OrientedPointsf& points, Family family, int iterations);

/// Fits the families and selects one.
/// @param general  the fit of the general family: no other fits better, which spares most fits
Selection select_family(const OrientedPointsf& points, std::span<const Family> families,
                        const FamilyFit& general, const SelectionOptions& options);

}  // namespace quadrille
