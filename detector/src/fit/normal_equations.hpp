#pragma once

#include <Eigen/Core>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// In the coordinates and the unit of the points:
/// [JᵀJ Jᵀr; rᵀJ rᵀr] of the first-order distances r = f / |∇f| of the points, J = dr/dq: 11x11,
/// in the order of q and with the residual last.
template <typename Scalar>
Eigen::Matrix<double, 11, 11> normal_equations(const OrientedPoints<Scalar>& points,
                                               const Eigen::Matrix4d& Q);

/// Sum of squared first-order distances of the points, the last element of the above.
template <typename Scalar>
double sum_of_squares(const OrientedPoints<Scalar>& points, const Eigen::Matrix4d& Q);

}  // namespace quadrille
