#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include "fit/oriented_point.hpp"

namespace quadrille {

/// The data of a fit: points of a surface and its normals there, one column each. Each coordinate
/// is contiguous over all points, so that loops over points vectorise. The detector uses single
/// precision for speed, the fits of detector/fits double precision for exactness.
template <typename Scalar>
struct OrientedPoints {
  using Matrix = Eigen::Matrix<Scalar, 3, Eigen::Dynamic, Eigen::RowMajor>;
  /// One coordinate of all points.
  using Coordinates = Eigen::Map<const Eigen::Array<Scalar, Eigen::Dynamic, 1>>;

  /// 3xN positions.
  Matrix points;
  /// 3xN normals, of unit length unless a fit states that it reads the gradient's length from them.
  Matrix normals;

  explicit OrientedPoints(Eigen::Index size = 0) : points(3, size), normals(3, size) {}
  Eigen::Index size() const { return points.cols(); }
  OrientedPoint at(Eigen::Index i) const {
    return {points.col(i).template cast<double>(), normals.col(i).template cast<double>()};
  }
  /// The first `count` columns.
  /// @throws std::invalid_argument if the numbers of points and normals differ
  OrientedPoints first(Eigen::Index count) const {
    if (points.cols() != normals.cols()) {
      throw std::invalid_argument("fit: the numbers of points and normals differ");
    }
    OrientedPoints part;
    part.points = points.leftCols(count);
    part.normals = normals.leftCols(count);
    return part;
  }

  Coordinates x() const { return row(points, 0); }
  Coordinates y() const { return row(points, 1); }
  Coordinates z() const { return row(points, 2); }
  Coordinates nx() const { return row(normals, 0); }
  Coordinates ny() const { return row(normals, 1); }
  Coordinates nz() const { return row(normals, 2); }

 private:
  static Coordinates row(const Matrix& matrix, Eigen::Index k) {
    return Coordinates(matrix.data() + k * matrix.cols(), matrix.cols());
  }
};

using OrientedPointsf = OrientedPoints<float>;
using OrientedPointsd = OrientedPoints<double>;

}  // namespace quadrille
