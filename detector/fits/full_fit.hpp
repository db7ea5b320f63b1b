#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct FullFitOptions {
  /// w, the weight of a normal's rows relative to a point's row, in normalised coordinates.
  double weight = 1.0;
};

/// A quadric with the gradient scale of each normal.
struct FullFit {
  Quadric Q;
  /// The scales αᵢ for which ∇f(xᵢ) ≈ αᵢ nᵢ.
  Eigen::VectorXd alpha;
};

/// Least squares of the full system with a scale per normal (paper, eq. 4): the singular vector of
/// A′ with the least singular value σ.
///
/// A′ is never built. Eliminating α gives (S − B Bᵀ w⁴ / (w² − μ)) q = μ q with μ = σ², and
/// Newton's method on this 10x10 secular equation gives the same vector in time linear in N. With
/// noise, the result depends on the frame's axes, since |(q, α)| = 1 does.
/// @param points  at least 4
/// @return nullopt if the points are too few, coplanar, or admit another solution
std::optional<FullFit> solve_full_system(const OrientedPointsd& points,
                                         const FullFitOptions& options = {});

/// The quadric of solve_full_system().
std::optional<Quadric> fit_full(const OrientedPointsd& points, const FullFitOptions& options = {});

}  // namespace quadrille
