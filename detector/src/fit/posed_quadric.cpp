#include "fit/posed_quadric.hpp"

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

Eigen::Isometry3d pose_along(const Eigen::Vector3d& position, const Eigen::Vector3d& z) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z).toRotationMatrix();
  X.translation() = position;
  return X;
}

CanonicalForm canonical_form(const PosedQuadric& fit) {
  return canonical_form(Quadric(fit.matrix()), 1e-7);
}

Eigen::Matrix4d PosedQuadric::matrix() const {
  const Eigen::Matrix4d Y = X.inverse().matrix();
  return Y.transpose() * D * Y;
}

}  // namespace quadrille
