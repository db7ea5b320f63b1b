#include "quadrille/detector/geometric_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// Where the gradient is weaker than this share of its mean, the first-order distance is cut: near
// an apex or a centre it would explode.
constexpr float kWeakGradient = 0.05f;
// A step that promises less than this share of the residual is not worth its evaluation.
constexpr double kNegligible = 1e-4;
// A fit that promises more than this multiple of the wanted residual will not get there.
constexpr double kHopeless = 4.0;

/// Values, gradients and inverse slopes of Q at the points.
struct Evaluation {
  Eigen::ArrayXf gx, gy, gz, inverse, residual;

  Evaluation(const FitPoints& p, const Eigen::Matrix4d& matrix) {
    const Eigen::Matrix4f Q = matrix.cast<float>();
    gx = Q(0, 0) * p.x + Q(0, 1) * p.y + Q(0, 2) * p.z + Q(0, 3);
    gy = Q(0, 1) * p.x + Q(1, 1) * p.y + Q(1, 2) * p.z + Q(1, 3);
    gz = Q(0, 2) * p.x + Q(1, 2) * p.y + Q(2, 2) * p.z + Q(2, 3);
    const Eigen::ArrayXf f =
        gx * p.x + gy * p.y + gz * p.z + Q(0, 3) * p.x + Q(1, 3) * p.y + Q(2, 3) * p.z + Q(3, 3);
    const Eigen::ArrayXf slope = (gx.square() + gy.square() + gz.square()).sqrt();
    const float least = std::max(1e-20f, kWeakGradient * slope.mean());
    inverse = 0.5f / slope.max(least);
    residual = f * inverse;
  }
};

using Normal = Eigen::Matrix<double, 11, 11>;

/// JᵀJ, Jᵀr and rᵀr of the residuals r with respect to the 10-vector q, in one 11x11 matrix.
Normal normal_equations(const FitPoints& p, const Eigen::Matrix4d& Q) {
  const Evaluation e(p, Q);
  const Eigen::ArrayXf rx = e.residual * e.inverse * 2.0f * e.gx;
  const Eigen::ArrayXf ry = e.residual * e.inverse * 2.0f * e.gy;
  const Eigen::ArrayXf rz = e.residual * e.inverse * 2.0f * e.gz;
  // dr/dq = (v - r ∇vᵀ g / |g|) / |g|, where g is the gradient and its halves are in e.
  Eigen::Matrix<float, Eigen::Dynamic, 11> J(p.size(), 11);
  J.col(0) = (p.x * (p.x - 2.0f * rx) * e.inverse).matrix();
  J.col(1) = (p.y * (p.y - 2.0f * ry) * e.inverse).matrix();
  J.col(2) = (p.z * (p.z - 2.0f * rz) * e.inverse).matrix();
  J.col(3) = (2.0f * (p.x * p.y - p.y * rx - p.x * ry) * e.inverse).matrix();
  J.col(4) = (2.0f * (p.x * p.z - p.z * rx - p.x * rz) * e.inverse).matrix();
  J.col(5) = (2.0f * (p.y * p.z - p.z * ry - p.y * rz) * e.inverse).matrix();
  J.col(6) = (2.0f * (p.x - rx) * e.inverse).matrix();
  J.col(7) = (2.0f * (p.y - ry) * e.inverse).matrix();
  J.col(8) = (2.0f * (p.z - rz) * e.inverse).matrix();
  J.col(9) = e.inverse.matrix();
  J.col(10) = e.residual.matrix();
  Normal N;
  for (int a = 0; a < 11; ++a) {
    for (int b = a; b < 11; ++b) N(a, b) = N(b, a) = J.col(a).dot(J.col(b));
  }
  return N;
}

/// The generator of a motion as a 4x4 matrix of se(3).
Eigen::Matrix4d generator(int motion) {
  Eigen::Matrix4d G = Eigen::Matrix4d::Zero();
  if (motion < 3) {
    G(motion, 3) = 1.0;
  } else {
    const int a = (motion - 3 + 1) % 3, b = (motion - 3 + 2) % 3;
    G(b, a) = 1.0;
    G(a, b) = -1.0;
  }
  return G;
}

// At most ten parameters: no heap.
using Tangent = Eigen::Matrix<double, 10, Eigen::Dynamic, 0, 10, 10>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 10, 10>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 10, 1>;

/// dq/dθ of a family at a posed quadric: 10 x (shapes + motions).
Tangent tangent_space(const FamilySpec& spec, const PosedQuadric& q) {
  const Eigen::Matrix4d Y = q.X.inverse().matrix();
  Tangent T(10, static_cast<Eigen::Index>(spec.shapes.size() + spec.motions.size()));
  Eigen::Index column = 0;
  for (const Eigen::Matrix4d& shape : spec.shapes) {
    T.col(column++) = Quadric(Eigen::Matrix4d(Y.transpose() * shape * Y)).coefficients();
  }
  for (const int motion : spec.motions) {
    const Eigen::Matrix4d G = generator(motion);
    const Eigen::Matrix4d dD = -(G.transpose() * q.D + q.D * G);
    T.col(column++) = Quadric(Eigen::Matrix4d(Y.transpose() * dD * Y)).coefficients();
  }
  return T;
}

/// Gauss-Newton's equations A step = -b in a family's parameters.
struct Step {
  Tangent T;
  Square A;
  Vector b;

  Step(const FamilySpec& spec, const PosedQuadric& q, const Normal& N)
      : T(tangent_space(spec, q)),
        A(T.transpose().lazyProduct(Tangent(N.topLeftCorner<10, 10>().lazyProduct(T)))),
        b(T.transpose().lazyProduct(N.topRightCorner<10, 1>())) {}

  Vector solve(double damping) const {
    Square damped = A;
    damped.diagonal().array() +=
        damping * A.diagonal().array() + 1e-9 * A.diagonal().maxCoeff();
    return -damped.ldlt().solve(b);
  }
};

}  // namespace

Eigen::Matrix4d PosedQuadric::matrix() const {
  const Eigen::Matrix4d Y = X.inverse().matrix();
  return Y.transpose() * D * Y;
}

PosedQuadric moved(Family family, PosedQuadric q, const Eigen::Ref<const Eigen::VectorXd>& step) {
  const FamilySpec& spec = family_spec(family);
  Eigen::Index k = 0;
  for (const Eigen::Matrix4d& shape : spec.shapes) q.D += step[k++] * shape;
  Eigen::Vector3d t = Eigen::Vector3d::Zero(), r = Eigen::Vector3d::Zero();
  for (const int motion : spec.motions) (motion < 3 ? t[motion] : r[motion - 3]) = step[k++];
  Eigen::Isometry3d dX = Eigen::Isometry3d::Identity();
  if (r.norm() > 0) dX.linear() = Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix();
  dX.translation() = t;
  q.X = q.X * dX;
  // Only the general family is free in scale; the others hold a coefficient fixed.
  if (spec.motions.empty()) q.D /= q.D.norm();
  return q;
}

double sum_of_squares(const FitPoints& points, const Eigen::Matrix4d& Q) {
  return Evaluation(points, Q).residual.square().sum();
}

std::optional<FamilyFit> refine(const FitPoints& points, Family family, const PosedQuadric& start,
                                int iterations, double wanted) {
  const FamilySpec& spec = family_spec(family);
  if (points.size() < spec.dof) return std::nullopt;
  FamilyFit fit;
  fit.family = family;
  fit.posed = start;
  fit.points = static_cast<int>(points.size());
  Normal N = normal_equations(points, start.matrix());
  if (!N.allFinite()) return std::nullopt;
  fit.rss = N(10, 10);
  Step step(spec, fit.posed, N);
  double damping = 1e-3;
  for (int i = 0; i < iterations; ++i) {
    const Vector change = step.solve(damping);
    if (!change.allFinite()) break;
    const double gain = -step.b.dot(change);
    if (gain < kNegligible * fit.rss) break;
    if (i > 0 && fit.rss - gain > kHopeless * wanted) break;
    const PosedQuadric next = moved(family, fit.posed, change);
    const Normal M = normal_equations(points, next.matrix());
    if (M.allFinite() && M(10, 10) < fit.rss) {
      const bool converged = M(10, 10) > 0.999 * fit.rss;
      fit.posed = next;
      fit.rss = M(10, 10);
      N = M;
      step = Step(spec, fit.posed, N);
      damping *= 0.1;
      if (converged) break;
    } else {
      damping *= 10.0;
      if (damping > 1e3) break;
    }
  }
  fit.information = step.A;
  return fit;
}

}  // namespace quadrille
