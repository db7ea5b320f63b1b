#pragma once

#include <Eigen/Core>

#include "fits/linear_system.hpp"

namespace quadrille {

/// All solutions q = p + N λ of an underdetermined linear system A q = n (paper, eq. 6). Nothing
/// in it is particular to quadrics.
struct SolutionSpace {
  /// The particular solution of least norm.
  Eigen::VectorXd p;
  /// Orthonormal basis of the null space of A, one column a dimension.
  Eigen::MatrixXd null_space;
  /// Rank of A; the null space has the other D = cols − rank dimensions.
  Eigen::Index rank = 0;

  /// p + N λ.
  Eigen::VectorXd at(const Eigen::VectorXd& lambda) const { return p + null_space * lambda; }
};

/// The solution space by SVD.
/// @param tolerance  singular values below this share of the largest count as zero
SolutionSpace solution_space(const LinearSystem& system, double tolerance = 1e-9);

/// λ of the further constraints A_k q = n_k, in the sense of least squares: (A_k N) λ = n_k − A_k p
/// (paper, theorem 2, eq. 7).
Eigen::VectorXd solve_lambda(const SolutionSpace& space, const LinearSystem& further);

/// The same in a null space of one dimension: λ = (A_k μ)ᵀ (n_k − A_k p) / |A_k μ|² (paper,
/// theorem 3, eq. 10).
/// @throws std::invalid_argument if the null space has another dimension
double solve_single_lambda(const SolutionSpace& space, const LinearSystem& further);

}  // namespace quadrille
