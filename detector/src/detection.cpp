#include "quadrille/detector/detection.hpp"

namespace quadrille {

Eigen::Quaterniond rotation_of(const Eigen::Isometry3d& X) {
  // A quaternion that is computed from a rotation matrix is off by 2e-15 at most. Multiples of the
  // step are far enough apart to be found again in spite of that.
  constexpr double kStep = 0x1p-44;
  Eigen::Quaterniond R(X.linear());
  Eigen::Index largest = 0;
  R.coeffs().cwiseAbs().maxCoeff(&largest);
  const Eigen::Vector4d ratios = R.coeffs() / R.coeffs()[largest];
  R.coeffs() = (ratios / kStep).array().round() * kStep;
  R.normalize();
  if (R.w() < 0.0) R.coeffs() = -R.coeffs();
  return R;
}

Eigen::Isometry3d rounded(const Eigen::Isometry3d& X) {
  Eigen::Isometry3d result = X;
  // Readers normalise too, since others write quaternions with fewer digits.
  result.linear() = rotation_of(X).normalized().toRotationMatrix();
  return result;
}

}  // namespace quadrille
