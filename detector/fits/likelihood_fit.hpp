#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct LikelihoodFitOptions {
  /// Rounds of estimating the noise and refitting.
  int rounds = 6;
  /// Most Gauss-Newton steps a round.
  int iterations = 15;
  /// How many of the points each normal was estimated from: normals of overlapping neighbourhoods
  /// share their errors, and count for the k-th part each. 1 for measured normals.
  double points_per_normal = 1.0;
};

/// A fit with the noise that it found.
struct LikelihoodFit {
  Quadric Q;
  /// Standard deviation of a coordinate [unit of the points] and of a normal's direction [rad].
  double point_noise = 0.0, normal_noise = 0.0;
};

/// The likeliest quadric for points AND normals, both noisy by amounts that are estimated too.
///
/// A point yᵢ of the surface is seen as xᵢ = yᵢ + σ ε with the normal nᵢ = n(yᵢ) + ρ η. At the foot
/// of xᵢ the distance d has variance σ² and, as the surface is curved, the mean σ² tr(S) / 2, which
/// is subtracted; the normal's deviation has the covariance ρ² 1 + σ² S Sᵀ, since the true yᵢ lies
/// somewhere beside the foot (S: shape operator there, Σ of the unknown yᵢ integrated out in the
/// first order). So a normal counts for much where the surface is flat or the points are good, and
/// for little at a sharp bend. σ and ρ follow from the residuals in turn with the fit.
/// @param points  4 or more
/// @return nullopt if the points are too few, coplanar, or give no start
std::optional<LikelihoodFit> solve_likelihood(const OrientedPointsd& points,
                                              const LikelihoodFitOptions& options = {});

/// The quadric of solve_likelihood().
std::optional<Quadric> fit_likelihood(const OrientedPointsd& points,
                                      const LikelihoodFitOptions& options = {});

}  // namespace quadrille
