#pragma once

#include <Eigen/Cholesky>
#include <algorithm>

namespace quadrille {

/// Sums for the least-squares fit of a quadratic height over a plane, h(s, t) = a₀ + a₁ s + a₂ t +
/// a₃ s² + a₄ s t + a₅ t². Lengths are in the caller's unit.
struct HeightFit {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  Matrix6 A = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  double hh = 0.0;

  void add(double s, double t, double h) {
    Vector6 row;
    row << 1, s, t, s * s, s * t, t * t;
    A += row * row.transpose();
    b += h * row;
    hh += h * h;
  }
  /// Factorises the normal equations; solve(b) of the result gives the coefficients a.
  Eigen::LDLT<Matrix6> factor() const { return Eigen::LDLT<Matrix6>(A); }
  /// Sum of squared residuals for the coefficients a.
  double rss(const Vector6& a) const { return std::max(0.0, hh - a.dot(b)); }
};

}  // namespace quadrille
