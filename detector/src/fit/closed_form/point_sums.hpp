#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "fit/oriented_points.hpp"

namespace quadrille {

/// The products of columns MᵀM, summed in the precision of the points.
template <typename Derived>
auto products_of_columns(const Eigen::MatrixBase<Derived>& M) {
  constexpr int size = Derived::ColsAtCompileTime;
  return Eigen::Matrix<double, size, size>((M.transpose() * M).template cast<double>());
}

/// Σ n nᵀ over the normals, or Σ x xᵀ over the points.
template <typename Scalar>
Eigen::Matrix3d scatter_of(const Eigen::Matrix<Scalar, 3, Eigen::Dynamic, Eigen::RowMajor>& rows) {
  return products_of_columns(Eigen::Matrix<Scalar, Eigen::Dynamic, 3>(rows.transpose()));
}

/// Σ n (n·x). Together with Σ n nᵀ it gives the normal equations of the point common to all tangent
/// planes.
template <typename Scalar>
Eigen::Vector3d sum_of_planes(const OrientedPoints<Scalar>& p) {
  using Array = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
  const Array d = p.nx() * p.x() + p.ny() * p.y() + p.nz() * p.z();
  return Eigen::Matrix<Scalar, 3, 1>((p.nx() * d).sum(), (p.ny() * d).sum(), (p.nz() * d).sum())
      .template cast<double>();
}

}  // namespace quadrille
