#pragma once

#include "fit/monomials.hpp"
#include "fit/oriented_points.hpp"

namespace quadrille {

/// Sums over all points from which quadratic fits are made, each divided by the number of points.
struct Scatter {
  /// Σ v vᵀ, the quadratic form of the squared algebraic distance.
  Matrix10d values;
  /// Σ ∇v ∇vᵀ, the quadratic form of the squared norm of the gradient.
  Matrix10d gradients;
  /// Σ (∇v n)(∇v n)ᵀ, the quadratic form of the squared part of the gradient along the normal.
  Matrix10d along = Matrix10d::Zero();
  /// Σ ∇v n, the linear form of the gradient along the normal.
  Vector10d alignment = Vector10d::Zero();

  explicit Scatter(const OrientedPointsd& points);
  /// The quadratic form of the squared part of the gradient across the normal, Σ |tᵀ∇f|².
  Matrix10d across() const { return gradients - along; }
};

}  // namespace quadrille
