#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct GradientOneOptions {
  /// μ, the weight of the squared deviation of the gradient from the unit normal.
  double gradient_weight = 1.0;
  /// κ of the ridge that favours small second-order coefficients where the data leave them open,
  /// relative to the mean square of the values.
  double ridge = 1e-3;
};

/// Tasdizen's gradient-one fit with ridge regression: least
/// Σ f² + μ Σ ((n·∇f − 1)² + |t·∇f|²) + κ |Q₃₃|²
/// (T. Tasdizen, J.-P. Tarel, D. B. Cooper, "Improving the stability of algebraic curves for
/// applications", IEEE Trans. Image Processing 2000, in three dimensions as in Tasdizen's thesis
/// of 2001). The ridge weighs with the Frobenius norm of the quadratic part, which rotations keep.
/// @param points  4 or more
/// @return nullopt if the points are too few or coplanar
std::optional<Quadric> fit_gradient_one(const OrientedPointsd& points,
                                        const GradientOneOptions& options = {});

}  // namespace quadrille
