#pragma once

#include "fits/linear_system.hpp"

namespace quadrille {

using Matrix10d = Eigen::Matrix<double, 10, 10>;

/// Sums over all points that quadratic fits are made of, each divided by the number of points.
struct Scatter {
  /// Σ v vᵀ: squared algebraic distance.
  Matrix10d values = Matrix10d::Zero();
  /// Σ ∇v ∇vᵀ: squared norm of the gradient.
  Matrix10d gradients = Matrix10d::Zero();
  /// Σ (∇v n)(∇v n)ᵀ: squared part of the gradient along the normal.
  Matrix10d along = Matrix10d::Zero();
  /// Σ ∇v n.
  Vector10d alignment = Vector10d::Zero();

  explicit Scatter(const OrientedPoints& points);
  /// Squared part of the gradient across the normal, Σ |tᵀ∇f|².
  Matrix10d across() const { return gradients - along; }
};

}  // namespace quadrille
