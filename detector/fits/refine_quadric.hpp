#pragma once

#include <functional>
#include <optional>

#include "fits/scatter.hpp"

namespace quadrille {

/// Sums over residuals r with derivatives J with respect to q.
struct NormalEquations {
  Matrix10d JTJ = Matrix10d::Zero();
  Vector10d JTr = Vector10d::Zero();
  /// rᵀr
  double cost = 0.0;

  void add(const Vector10d& derivative, double residual, double weight = 1.0) {
    JTJ += weight * derivative * derivative.transpose();
    JTr += weight * residual * derivative;
    cost += weight * residual * residual;
  }
};

/// Computes the sums at a quadric with |q| = 1; nullopt if the residuals are not defined there.
using Linearise = std::function<std::optional<NormalEquations>(const Quadric&)>;

/// Least squares of any residuals over all quadrics, by damped Gauss-Newton steps
/// (Levenberg-Marquardt) on the unit sphere of q. In contrast, the detector's refine() minimises
/// the first-order distance over the quadrics of a family.
/// @return nullopt if the residuals are not defined at the start
std::optional<Quadric> refine_quadric(const Quadric& start, const Linearise& linearise,
                                      int iterations);

}  // namespace quadrille
