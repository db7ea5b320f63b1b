#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct LikelihoodFitOptions {
  /// Rounds of estimating the noise and refitting.
  int rounds = 6;
  /// Largest number of Gauss-Newton steps per round.
  int iterations = 15;
  /// Number of points k from which each normal was estimated. Normals of overlapping neighbourhoods
  /// share their errors, so each counts as 1/k; use 1 for measured normals.
  double points_per_normal = 1.0;
};

/// A fit with the noise that it estimated.
struct LikelihoodFit {
  Quadric Q;
  /// Standard deviation of a coordinate [unit of the points] and of a normal's direction [rad].
  double point_noise = 0.0, normal_noise = 0.0;
};

/// Finds the most likely quadric for both points and normals, whose noise is estimated too.
///
/// A point yᵢ of the surface is observed as xᵢ = yᵢ + σ ε with the normal nᵢ = n(yᵢ) + ρ η. At the
/// foot of xᵢ the distance d has variance σ² and, since the surface is curved, the mean σ² tr(S) /
/// 2, which is subtracted, where S is the shape operator there. The deviation of the normal has the
/// covariance ρ² 1 + σ² S Sᵀ, since the true yᵢ lies somewhere beside the foot (yᵢ is integrated
/// out to first order). So a normal has a large weight where the surface is flat or the points are
/// accurate, and a small one at a sharp bend. σ and ρ are estimated from the residuals in turn with
/// the fit.
/// @param points  at least 4
/// @return nullopt if the points are too few, coplanar, or give no start
std::optional<LikelihoodFit> solve_likelihood(const OrientedPointsd& points,
                                              const LikelihoodFitOptions& options = {});

/// The quadric of solve_likelihood().
std::optional<Quadric> fit_likelihood(const OrientedPointsd& points,
                                      const LikelihoodFitOptions& options = {});

}  // namespace quadrille
