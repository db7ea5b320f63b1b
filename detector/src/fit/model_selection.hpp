#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/distance_sums.hpp"
#include "fit/family_fit.hpp"
#include "fit/starts.hpp"

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

/// Fits of families to one set of points, which are summed and laid out once for all of them.
class FamilyFits {
 public:
  explicit FamilyFits(const OrientedPointsf& points) : starts_(points), sums_(points) {}

  /// The best fit of one family from its own closed-form starts. Nullopt if it has none:
  /// paraboloids and the elliptic cylinder start from fits of other families.
  std::optional<FamilyFit> fit(Family family, int iterations);

  /// Fits the families and selects one.
  /// @param general  fit of the general family; no other family fits better, which makes most fits
  ///   unnecessary
  Selection select(std::span<const Family> families, const FamilyFit& general,
                   const SelectionOptions& options);

 private:
  std::optional<FamilyFit> fit_from(Family family, const std::vector<FamilyFit>& known,
                                    int iterations, double wanted);

  Starts starts_;
  DistanceSums<float> sums_;
};

/// FamilyFits::fit() of one family.
std::optional<FamilyFit> fit_family(const OrientedPointsf& points, Family family, int iterations);

}  // namespace quadrille
