#include "quadrille/detector/detection.hpp"

namespace quadrille {

Eigen::Quaterniond rotation_of(const Eigen::Isometry3d& X) {
  Eigen::Quaterniond R(X.linear());
  R.normalize();
  if (R.w() < 0.0) R.coeffs() = -R.coeffs();
  return R;
}

}  // namespace quadrille
