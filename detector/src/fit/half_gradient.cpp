#include "fit/half_gradient.hpp"

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

/// Evaluates the half gradients and values of many points.
/// @param from  rows of the 3xN points
/// @param to    rows of the 4xN results
QUADRILLE_VECTOR_CLONES
void evaluate(Coefficients<float> q, Eigen::Index size, const float* from, float* __restrict to) {
  const float *x = from, *y = x + size, *z = y + size;
  float *gx = to, *gy = gx + size, *gz = gy + size, *f = gz + size;
  for (Eigen::Index i = 0; i < size; ++i) {
    const HalfGradient<float> g = half_gradient(q, x[i], y[i], z[i]);
    gx[i] = g.x, gy[i] = g.y, gz[i] = g.z, f[i] = g.f;
  }
}

}  // namespace

HalfGradients::HalfGradients(const OrientedPointsf& points, const Eigen::Matrix4d& Q)
    : rows_(4, points.size()) {
  evaluate(Coefficients<float>(Q), points.size(), points.points.data(), rows_.data());
}

}  // namespace quadrille
