#include "fits/linear_system.hpp"

namespace quadrille {

Eigen::MatrixXd full_system(const OrientedPointsd& points, double weight) {
  const Eigen::Index count = points.size();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4 * count, 10 + count);
  const LinearSystem compact = compact_system(points, weight);
  A.leftCols<10>() = compact.A;
  for (Eigen::Index i = 0; i < count; ++i) {
    A.block<3, 1>(count + 3 * i, 10 + i) = -compact.n.segment<3>(count + 3 * i);
  }
  return A;
}

LinearSystem compact_system(const OrientedPointsd& points, double weight) {
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
