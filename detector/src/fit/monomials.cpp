#include "fit/monomials.hpp"

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

}  // namespace quadrille
