#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct BayesianFitOptions {
  /// Standard deviation of f at a data point, at the scale of f that the prior sets.
  double noise = 0.1;
  /// Standard deviation of each entry of the quadratic part around the identity.
  double prior_deviation = 1.0;
};

/// Maximum a posteriori fit with a matrix normal prior that favours ellipsoids (D. Beale, Y.-L.
/// Yang, N. Campbell, D. Cosker, P. Hall, "Fitting quadrics with a Bayesian prior", Computational
/// Visual Media 2016). Residuals f(xᵢ) are Gaussian, and Q₃₃ is normal around the identity, which
/// also fixes the scale: linear least squares of Σ f² / σ² + |Q₃₃ − 1|² / τ².
///
/// Mean and both covariances are isotropic in the normalised frame, so that the fit is the same in
/// every frame; the article takes them from training data if there are any.
/// @param points  at least 4; normals only choose the gradient's side
/// @return nullopt if the points are too few or coplanar
std::optional<Quadric> fit_bayesian(const OrientedPointsd& points,
                                    const BayesianFitOptions& options = {});

}  // namespace quadrille
