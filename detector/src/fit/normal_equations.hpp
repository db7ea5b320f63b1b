#pragma once

#include <Eigen/Core>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// Returns the 11x11 matrix [JᵀJ Jᵀr; rᵀJ rᵀr], where r = f / |∇f| are the points' first-order
/// distances and J = dr/dq. Rows are in the order of q, the residual last; coordinates and unit are
/// those of the points.
template <typename Scalar>
Eigen::Matrix<double, 11, 11> normal_equations(const OrientedPoints<Scalar>& points,
                                               const Eigen::Matrix4d& Q);

/// Sum of the points' squared first-order distances, which is the last element of
/// normal_equations().
template <typename Scalar>
double sum_of_squares(const OrientedPoints<Scalar>& points, const Eigen::Matrix4d& Q);

}  // namespace quadrille
