#pragma once

#include <Eigen/Core>

#include "fits/oriented_points.hpp"

namespace quadrille {

/// The monomials v of a point, f = vᵀq (paper, definition 1).
Vector10d monomials(const Eigen::Vector3d& x);

/// The transposed derivative ∇vᵀ of the monomials, 3x10: ∇f = ∇vᵀq (paper, eq. 3).
Eigen::Matrix<double, 3, 10> monomial_gradients(const Eigen::Vector3d& x);

/// A linear system A q = n.
struct LinearSystem {
  Eigen::MatrixXd A;
  Eigen::VectorXd n;
};

/// The full system A′ of 4Nx(N + 10) with a scale αᵢ per normal, A′ (q, α) = 0 (paper, eq. 4):
/// first N rows vᵢᵀ, then three rows ∇vᵢᵀ q − αᵢ nᵢ for each point.
/// @param weight  w of the normals' rows
Eigen::MatrixXd full_system(const OrientedPoints& points, double weight = 1.0);

/// The compact system of 4Nx10 with one common scale (paper, eq. 5): first N rows vᵢᵀq = 0, then
/// three rows ∇vᵢᵀ q = nᵢ for each point.
/// @param weight  w of the normals' rows
LinearSystem compact_system(const OrientedPoints& points, double weight = 1.0);

}  // namespace quadrille
