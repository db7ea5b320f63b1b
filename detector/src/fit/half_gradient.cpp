#include "fit/half_gradient.hpp"

#include "base/vector_clones.hpp"

namespace quadrille {
namespace {

QUADRILLE_VECTOR_CLONES
void evaluate(Coefficients<float> q, const OrientedPointsf& points, HalfGradients* g) {
  const Eigen::Index size = points.size();
  const float *x = points.x().data(), *y = points.y().data(), *z = points.z().data();
  float *gx = g->x.data(), *gy = g->y.data(), *gz = g->z.data(), *f = g->f.data();
#pragma GCC ivdep
  for (Eigen::Index i = 0; i < size; ++i) {
    const HalfGradient<float> at = half_gradient(q, x[i], y[i], z[i]);
    gx[i] = at.x, gy[i] = at.y, gz[i] = at.z, f[i] = at.f;
  }
}

}  // namespace

HalfGradients::HalfGradients(const OrientedPointsf& points, const Eigen::Matrix4d& Q)
    : x(points.size()), y(points.size()), z(points.size()), f(points.size()) {
  evaluate(Coefficients<float>(Q), points, this);
}

}  // namespace quadrille
