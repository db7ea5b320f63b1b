#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/monomials.hpp"
#include "fit/oriented_points.hpp"

namespace quadrille {

/// Taubin's fit: least mean squared value under the constraint that the squared gradient has mean
/// 1, a generalised eigenvalue problem (G. Taubin, "Estimation of planar curves, surfaces, and
/// nonplanar space curves defined by implicit equations", PAMI 1991).

/// Σ v vᵀ: squared algebraic distance.
template <typename Scalar>
Matrix10d scatter_of_values(const OrientedPoints<Scalar>& points);

/// Σ ∇v ∇vᵀ: squared norm of the gradient, whose sums are among those of the values.
Matrix10d scatter_of_gradients(const Matrix10d& values);

struct TaubinSolution {
  Vector10d q;
  /// The least squared distance, then those of further solutions, ascending.
  Eigen::Matrix<double, 9, 1> distances;
};

/// @param values  Σ v vᵀ
/// @param ridge   added to the weight's diagonal in shares of its trace, so that sums of single
///                precision keep it positive; 0 for exact ones
/// @return nullopt if the points do not determine a finite solution
std::optional<TaubinSolution> solve_taubin(const Matrix10d& values, double ridge);

}  // namespace quadrille
