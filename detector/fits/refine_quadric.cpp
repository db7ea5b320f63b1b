#include "fits/refine_quadric.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace quadrille {
namespace {

/// A damped step orthogonal to q; not finite if there is none.
Vector10d damped_step(const NormalEquations& at, const Vector10d& q, double damping) {
  Matrix10d A = at.JTJ;
  const double size = A.trace() / 10.0;
  A.diagonal() += damping * A.diagonal() + Vector10d::Constant(1e-12 * size);
  A += size * q * q.transpose();
  return -A.ldlt().solve(at.JTr);
}

}  // namespace

std::optional<Quadric> refine_quadric(const Quadric& start, const Linearise& linearise,
                                      int iterations) {
  Vector10d q = start.normalized().coefficients();
  auto at = linearise(Quadric(q));
  if (!at || !std::isfinite(at->cost) || !at->JTJ.allFinite()) return std::nullopt;
  double damping = 1e-4;
  for (int i = 0; i < iterations && damping < 1e8; ++i) {
    const Vector10d next = (q + damped_step(*at, q, damping)).normalized();
    const auto there = next.allFinite() ? linearise(Quadric(next)) : std::nullopt;
    if (!there || !(there->cost < at->cost) || !there->JTJ.allFinite()) {
      damping *= 10.0;
      continue;
    }
    const bool converged = there->cost > (1.0 - 1e-9) * at->cost;
    q = next;
    at = there;
    damping *= 0.1;
    if (converged) break;
  }
  return Quadric(q);
}

}  // namespace quadrille
