#include "fit/posed_quadric.hpp"

#include "quadrille/detector/quadric.hpp"

namespace quadrille {

CanonicalForm canonical_form(const PosedQuadric& fit) {
  return canonical_form(Quadric(fit.matrix()), 1e-7);
}

Eigen::Matrix4d PosedQuadric::matrix() const {
  const Eigen::Matrix4d Y = X.inverse().matrix();
  return Y.transpose() * D * Y;
}

}  // namespace quadrille
