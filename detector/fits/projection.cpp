#include "fits/projection.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fits/polynomial.hpp"

namespace quadrille {
namespace {

using Polynomial = std::vector<double>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

void add(Polynomial& sum, const Polynomial& term) {
  if (sum.size() < term.size()) sum.resize(term.size(), 0.0);
  for (std::size_t i = 0; i < term.size(); ++i) sum[i] += term[i];
}

/// The quadric f = λ·y² + 2 b·y + j in the eigenframe of its quadratic part, and the point to
/// project.
struct Local {
  Eigen::Vector3d lambda, b, x;
  double j;

  double value(const Eigen::Vector3d& y) const {
    return lambda.dot(y.cwiseAbs2()) + 2.0 * b.dot(y) + j;
  }
};

/// The polynomial f(y(t)) Π (1 + tλₖ)², in which equal eigenvalues contribute one factor.
Polynomial foot_polynomial(const Local& q) {
  std::array<Polynomial, 3> squares;
  for (int k = 0; k < 3; ++k) {
    squares[k] = product({1.0, q.lambda[k]}, {1.0, q.lambda[k]});
  }
  // Equal eigenvalues share their factor.
  std::array<bool, 3> shared = {false, false, false};
  for (int k = 1; k < 3; ++k) {
    for (int m = 0; m < k; ++m) {
      if (q.lambda[k] == q.lambda[m]) shared[k] = true;
    }
  }
  const auto others = [&](int k) {
    Polynomial p = {1.0};
    for (int m = 0; m < 3; ++m) {
      if (!shared[m] && (k < 0 || q.lambda[m] != q.lambda[k])) p = product(p, squares[m]);
    }
    return p;
  };
  Polynomial f = others(-1);
  for (double& c : f) c *= q.j;
  for (int k = 0; k < 3; ++k) {
    // This is λ y² + 2 b y with y = (x − t b) / (1 + tλ).
    const Polynomial y = {q.x[k], -q.b[k]};
    Polynomial term = product(y, y);
    for (double& c : term) c *= q.lambda[k];
    Polynomial linear = product(y, {1.0, q.lambda[k]});
    for (double& c : linear) c *= 2.0 * q.b[k];
    add(term, linear);
    add(f, product(term, others(k)));
  }
  return f;
}

struct Nearest {
  const Local& q;
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();

  /// Accepts a candidate if it lies on the surface and is nearer than the present one.
  void offer(const Eigen::Vector3d& y) {
    if (!y.allFinite()) return;
    const double size = q.lambda.cwiseAbs().dot(y.cwiseAbs2()) +
                        2.0 * q.b.cwiseAbs().dot(y.cwiseAbs()) + std::abs(q.j);
    if (std::abs(q.value(y)) > 1e-7 * size) return;
    const double d = (y - q.x).norm();
    if (d < distance) distance = d, foot = y;
  }
};

/// Offers the feet for which the denominator 1 + tλₖ vanishes: coordinate k is free, and those of
/// equal eigenvalues stay at their centre.
void offer_pole(const Local& q, int k, Nearest& nearest) {
  if (q.lambda[k] == 0.0) return;
  const double t = -1.0 / q.lambda[k];
  Eigen::Vector3d y;
  for (int m = 0; m < 3; ++m) {
    const double denominator = 1.0 + t * q.lambda[m];
    y[m] =
        std::abs(denominator) < 1e-12 ? -q.b[m] / q.lambda[m] : (q.x[m] - t * q.b[m]) / denominator;
  }
  // The equation for yₖ is λ (yₖ − centre)² + value at the centre = 0.
  const double square = -q.value(y) / q.lambda[k];
  const double centre = y[k];
  // A point that is off the plane of symmetry only by rounding is projected as if it were on it.
  if (!(square >= 0.0) || std::abs(q.x[k] - centre) > 1e-9 * (1.0 + std::abs(centre))) return;
  for (const double sign : {-1.0, 1.0}) {
    y[k] = centre + sign * std::sqrt(square);
    nearest.offer(y);
  }
}

Local localise(const Quadric& Q, const Eigen::Vector3d& x, Eigen::Matrix3d& R) {
  const Eigen::Matrix4d M = Q.matrix() / Q.matrix().norm();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      Eigen::Matrix3d(M.topLeftCorner<3, 3>()));
  R = solver.eigenvectors();
  Local q{solver.eigenvalues(), R.transpose() * M.topRightCorner<3, 1>(), R.transpose() * x,
          M(3, 3)};
  const double least = 1e-13 * q.lambda.cwiseAbs().maxCoeff();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(q.lambda[k]) <= least) q.lambda[k] = 0.0;
    if (k > 0 && std::abs(q.lambda[k] - q.lambda[k - 1]) <= least) q.lambda[k] = q.lambda[k - 1];
  }
  return q;
}

/// Newton's method from (y, t) for a stationary point of |y − x|² / 2 + t f(y), with |Q| = 1.
std::optional<Eigen::Vector3d> find_foot(const Quadric& Q, const Eigen::Vector3d& x,
                                         Eigen::Vector3d y, double t) {
  const Eigen::Matrix3d H = 2.0 * Q.matrix().topLeftCorner<3, 3>();
  for (int step = 0; step < 12; ++step) {
    const Eigen::Vector3d g = Q.gradient(y);
    Eigen::Matrix4d K = Eigen::Matrix4d::Zero();
    K.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + t * H;
    K.topRightCorner<3, 1>() = g;
    K.bottomLeftCorner<1, 3>() = g.transpose();
    Eigen::Vector4d residual;
    residual << y - x + t * g, Q.value(y);
    const Eigen::Vector4d change = K.partialPivLu().solve(residual);
    if (!change.allFinite()) return std::nullopt;
    y -= change.head<3>();
    t -= change[3];
    if (change.head<3>().norm() < 1e-12 * (1.0 + y.norm())) return y;
  }
  return std::nullopt;
}

Quadric of_unit_norm(const Quadric& Q) {
  return Quadric(Eigen::Matrix4d(Q.matrix() / Q.matrix().norm()));
}

}  // namespace

std::optional<Eigen::Vector3d> project(const Quadric& Q, const Eigen::Vector3d& x) {
  if (!Q.matrix().allFinite() || Q.matrix().isZero(0.0) || !x.allFinite()) return std::nullopt;
  Eigen::Matrix3d R;
  const Local q = localise(Q, x, R);
  Nearest nearest{q};
  for (const double t : real_roots(foot_polynomial(q))) {
    nearest.offer((q.x - t * q.b).cwiseQuotient(Eigen::Vector3d::Ones() + t * q.lambda));
  }
  for (int k = 0; k < 3; ++k) offer_pole(q, k, nearest);
  if (!std::isfinite(nearest.distance)) return std::nullopt;
  // The roots of the polynomial have lost digits, which Newton's method restores.
  const Eigen::Vector3d foot = R * nearest.foot;
  const Quadric unit = of_unit_norm(Q);
  const Eigen::Vector3d g = unit.gradient(foot);
  const auto polished = find_foot(unit, x, foot, (x - foot).dot(g) / g.squaredNorm());
  const double slack = 1e-6 * (1.0 + nearest.distance);
  return polished && (*polished - foot).norm() <= slack ? polished : foot;
}

std::optional<Eigen::Vector3d> project_nearby(const Quadric& Q, const Eigen::Vector3d& x) {
  const Quadric unit = of_unit_norm(Q);
  const auto foot = find_foot(unit, x, x, 0.0);
  // The farthest point is stationary too, but the nearest one is not much farther than the
  // first-order distance.
  const double most = 2.0 * std::abs(unit.distance(x)) + 1e-12 * (1.0 + x.norm());
  return foot && (*foot - x).norm() <= most ? foot : std::nullopt;
}

}  // namespace quadrille
