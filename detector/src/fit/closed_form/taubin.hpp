#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/monomials.hpp"
#include "fit/oriented_points.hpp"

namespace quadrille {

/// Taubin's fit minimises the mean squared value under the constraint that the squared gradient has
/// mean 1, a generalised eigenvalue problem (G. Taubin, "Estimation of planar curves, surfaces, and
/// nonplanar space curves defined by implicit equations", PAMI 1991).

/// Σ v vᵀ, the quadratic form of the squared algebraic distance.
Matrix10d scatter_of_values(const OrientedPointsd& points);

/// Σ ∇v ∇vᵀ, the quadratic form of the squared norm of the gradient. All its sums occur in Σ v vᵀ.
Matrix10d scatter_of_gradients(const Matrix10d& values);

struct TaubinSolution {
  Vector10d q;
  /// The least squared distance, then those of further solutions, in ascending order.
  Eigen::Matrix<double, 9, 1> distances;
};

/// Solves the eigenvalue problem.
/// @param values  Σ v vᵀ
/// @param ridge   added to the weight's diagonal in shares of its trace, to keep it positive
///   definite despite sums in single precision; 0 for exact sums
/// @return nullopt if the points do not determine a finite solution
std::optional<TaubinSolution> solve_taubin(const Matrix10d& values, double ridge);

/// Solves it by inverse iteration for the least distance alone, in a tenth of the time. If several
/// solutions have nearly the least distance, as on planes, the result is a mixture of them.
std::optional<Vector10d> least_taubin(const Matrix10d& values, double ridge);

}  // namespace quadrille
