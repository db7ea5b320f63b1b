#pragma once

#include <Eigen/Core>

#include "fit/monomials.hpp"
#include "fit/oriented_points.hpp"

namespace quadrille {

/// Sums over the points of a fit. All closed-form fits follow from them, so the points are visited
/// once for all families.
struct PointMoments {
  /// Number of points.
  Eigen::Index size = 0;
  /// Σ v vᵀ over the monomials v of the points. The sum of the products of two quadratic functions
  /// of x, with coefficients a and b as in a quadric, is aᵀ (Σ v vᵀ) b.
  Matrix10d values = Matrix10d::Zero();
  /// Σ h hᵀ over h = (x × n, n, n·x, 1), where (x × n, n) is the normal line and (n, −n·x) the
  /// tangent plane.
  Eigen::Matrix<double, 8, 8> normals = Eigen::Matrix<double, 8, 8>::Zero();

  explicit PointMoments(const OrientedPointsf& points);

  /// Mean of the points.
  Eigen::Vector3d centre() const { return 0.5 / values(9, 9) * values.block<3, 1>(6, 9); }
  /// Σ x xᵀ.
  Eigen::Matrix3d scatter() const;
  /// Mean of the normals.
  Eigen::Vector3d mean_normal() const { return normals.block<3, 1>(3, 7) / normals(7, 7); }
  /// Σ n nᵀ.
  Eigen::Matrix3d normal_scatter() const { return normals.block<3, 3>(3, 3); }
};

/// The coefficients c of quadratic functions cᵀv, one in each column, of which the last is to be
/// approximated by the others: returns the factors of these by linear least squares.
template <int columns>
Eigen::Matrix<double, columns - 1, 1> least_squares(const PointMoments& moments,
                                                    const Eigen::Matrix<double, 10, columns>& c) {
  constexpr int size = columns - 1;
  const Eigen::Matrix<double, 10, columns> weighted = moments.values.lazyProduct(c);
  const Eigen::Matrix<double, size, columns> S =
      c.template leftCols<size>().transpose().lazyProduct(weighted);
  const Eigen::Matrix<double, size, size> A = S.template leftCols<size>();
  return A.ldlt().solve(S.template rightCols<1>());
}

/// The coefficients of the function xᵀAx + 2 b·x + j.
Vector10d quadratic(const Eigen::Matrix3d& A, const Eigen::Vector3d& b, double j);

}  // namespace quadrille
