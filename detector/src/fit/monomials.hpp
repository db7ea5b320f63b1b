#pragma once

#include <Eigen/Core>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

using Matrix10d = Eigen::Matrix<double, 10, 10>;

/// The monomials v of a point, so that f = vᵀq (paper, definition 1).
Vector10d monomials(const Eigen::Vector3d& x);

/// The transposed derivative ∇vᵀ of the monomials, 3x10, so that ∇f = ∇vᵀq (paper, eq. 3).
Eigen::Matrix<double, 3, 10> monomial_gradients(const Eigen::Vector3d& x);

/// The product of two affine functions a·[x 1] and b·[x 1] as a symmetric 4x4 matrix.
inline Eigen::Matrix4d symmetric_product(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  return 0.5 * (a * b.transpose() + b * a.transpose());
}

}  // namespace quadrille
