#include "fits/linear_system.hpp"

namespace quadrille {

Vector10d monomials(const Eigen::Vector3d& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  Vector10d v;
  v << x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, 2 * x, 2 * y, 2 * z, 1;
  return v;
}

Eigen::Matrix<double, 3, 10> monomial_gradients(const Eigen::Vector3d& p) {
  const double x = p.x(), y = p.y(), z = p.z();
  Eigen::Matrix<double, 3, 10> G;
  G << x, 0, 0, y, z, 0, 1, 0, 0, 0,  //
      0, y, 0, x, 0, z, 0, 1, 0, 0,   //
      0, 0, z, 0, x, y, 0, 0, 1, 0;
  return 2.0 * G;
}

Eigen::MatrixXd full_system(const OrientedPoints& points, double weight) {
  const Eigen::Index count = points.size();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4 * count, 10 + count);
  const LinearSystem compact = compact_system(points, weight);
  A.leftCols<10>() = compact.A;
  for (Eigen::Index i = 0; i < count; ++i) {
    A.block<3, 1>(count + 3 * i, 10 + i) = -compact.n.segment<3>(count + 3 * i);
  }
  return A;
}

LinearSystem compact_system(const OrientedPoints& points, double weight) {
  const Eigen::Index count = points.size();
  LinearSystem system{Eigen::MatrixXd(4 * count, 10), Eigen::VectorXd::Zero(4 * count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = count + 3 * i;
    system.A.row(i) = monomials(points.points.col(i));
    system.A.middleRows<3>(row) = weight * monomial_gradients(points.points.col(i));
    system.n.segment<3>(row) = weight * points.normals.col(i);
  }
  return system;
}

}  // namespace quadrille
