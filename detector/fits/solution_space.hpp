#pragma once

#include <Eigen/Core>

#include "fits/linear_system.hpp"

namespace quadrille {

/// All solutions q = p + N λ of an underdetermined linear system A q = n (paper, eq. 6). It is not
/// specific to quadrics.
struct SolutionSpace {
  /// The particular solution of least norm.
  Eigen::VectorXd p;
  /// Orthonormal basis of the null space of A, one column per dimension.
  Eigen::MatrixXd null_space;
  /// Rank of A; the null space has the remaining D = cols − rank dimensions.
  Eigen::Index rank = 0;

  /// Returns p + N λ.
  Eigen::VectorXd at(const Eigen::VectorXd& lambda) const { return p + null_space * lambda; }
};

/// Computes the solution space by SVD.
/// @param tolerance  singular values below this share of the largest count as zero
SolutionSpace solution_space(const LinearSystem& system, double tolerance = 1e-9);

/// Solves further constraints A_k q = n_k for λ by least squares: (A_k N) λ = n_k − A_k p (paper,
/// theorem 2, eq. 7).
Eigen::VectorXd solve_lambda(const SolutionSpace& space, const LinearSystem& further);

/// Solves further constraints in a null space of one dimension: λ = (A_k μ)ᵀ (n_k − A_k p) / |A_k
/// μ|² (paper, theorem 3, eq. 10).
/// @throws std::invalid_argument if the null space has another dimension
double solve_single_lambda(const SolutionSpace& space, const LinearSystem& further);

}  // namespace quadrille
