#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/geometric_fit.hpp"

namespace quadrille {

struct SelectionOptions {
  /// Independent measurements per point; neighbouring points share their noise.
  double effective_share = 0.25;
  /// Standard deviation of the noise that all points have in common, in their unit. A residual
  /// below it is no further evidence for a fit.
  double common_noise = 0.0;
  /// Number of steps of the geometric fit.
  int iterations = 6;
};

/// The fit preferred by the Bayesian information criterion, n ln(rss / N + c²) + k ln n minus twice
/// the type's log_prior(), where N is the number of points, n the effective sample size, k the
/// degrees of freedom and c the common noise. It is the simplest type that explains the points.
struct Selection {
  FamilyFit best;
  double bic = 0.0;
  /// Fits of all families that were tried.
  std::vector<FamilyFit> fits;
};

/// BIC of a fit to `size` points, without the prior.
double bic(double rss, int size, int dof, const SelectionOptions& options);

/// BIC of a fit, with the prior of its type.
double bic(const FamilyFit& fit, const SelectionOptions& options);

/// The best fit of one family from its own closed-form starts. Nullopt if it has none: paraboloids
/// and the elliptic cylinder start from fits of other families.
std::optional<FamilyFit> fit_family(const OrientedPointsf& points, Family family, int iterations);

/// Fits the families and selects one.
/// @param general  fit of the general family; no other family fits better, which makes most fits
///   unnecessary
Selection select_family(const OrientedPointsf& points, std::span<const Family> families,
                        const FamilyFit& general, const SelectionOptions& options);

}  // namespace quadrille
