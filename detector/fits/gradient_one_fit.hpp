#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct GradientOneOptions {
  /// μ, the weight of the squared deviation of the gradient from the unit normal.
  double gradient_weight = 1.0;
  /// κ, the weight of the ridge relative to the mean square of the values. The ridge favours small
  /// second-order coefficients if the data do not determine them.
  double ridge = 1e-3;
};

/// Tasdizen's gradient-one fit with ridge regression, which minimises
///   Σ f² + μ Σ ((n·∇f − 1)² + |t·∇f|²) + κ |Q₃₃|²
/// (T. Tasdizen, J.-P. Tarel, D. B. Cooper, "Improving the stability of algebraic curves for
/// applications", IEEE Trans. Image Processing 2000; in three dimensions as in Tasdizen's thesis of
/// 2001). The ridge uses the Frobenius norm of the quadratic part, which rotations preserve.
/// @param points  at least 4
/// @return nullopt if the points are too few or coplanar
std::optional<Quadric> fit_gradient_one(const OrientedPointsd& points,
                                        const GradientOneOptions& options = {});

}  // namespace quadrille
