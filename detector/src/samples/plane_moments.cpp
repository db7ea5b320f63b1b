#include "samples/plane_moments.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quadrille {
namespace {

// Any three points lie on a plane, so at least four are needed.
constexpr float kMinPoints = 4;
// The covariance is scaled to trace one, so its eigenvalues a <= b <= c, the variances along the
// principal axes, sum to one.
//
// The points lie on a line if b < kMinWidth c. Since b c / (b + c)² increases with b / c, this is
// equivalent to b c < kMinWidthProduct (b + c)², which needs only the sum and product of b and c.
constexpr double kMinWidth = 0.05;
constexpr double kMinWidthProduct = kMinWidth / ((1 + kMinWidth) * (1 + kMinWidth));
// If (b - a)(c - a) is less than this, a equals b or c, and no single direction has least spread.
constexpr double kMinSeparation = 1e-6;
// Largest number of Newton steps, and the step size and slope at which they end.
constexpr int kMaxSteps = 20;
constexpr double kMinStep = 1e-9;

/// The smallest root of λ³ − λ² + bλ − c, whose roots are real and not negative. Newton's steps
/// from zero approach it from below and never pass it.
double min_root(double b, double c) {
  double root = 0;
  for (int k = 0; k < kMaxSteps; ++k) {
    const double slope = (3 * root - 2) * root + b;
    if (!(slope > kMinStep)) break;
    const double step = (((root - 1) * root + b) * root - c) / slope;
    root -= step;
    if (std::abs(step) < kMinStep) break;
  }
  return root;
}

/// Matrix of the cofactors of a symmetric matrix.
Eigen::Matrix3d cofactors(const Eigen::Matrix3d& S) {
  Eigen::Matrix3d C;
  C.col(0) = S.col(1).cross(S.col(2));
  C.col(1) = S.col(2).cross(S.col(0));
  C.col(2) = S.col(0).cross(S.col(1));
  return C;
}

}  // namespace

std::optional<PlaneMoments::Plane> PlaneMoments::solve() const {
  if (n < kMinPoints) return std::nullopt;
  Plane plane;
  plane.mean = sum / n;
  const Eigen::Vector3d m = plane.mean.cast<double>();
  const Eigen::Vector3d ii = squares.matrix().cast<double>() / static_cast<double>(n);
  const Eigen::Vector3d ij = products.matrix().cast<double>() / static_cast<double>(n);
  Eigen::Matrix3d S;
  S << ii[0], ij[0], ij[2], ij[0], ii[1], ij[1], ij[2], ij[1], ii[2];
  S -= m * m.transpose();
  const double trace = S.trace();
  if (!(trace > 0)) return std::nullopt;
  S /= trace;
  const Eigen::Matrix3d C = cofactors(S);
  const double a = min_root(C.trace(), S.col(0).dot(C.col(0)));
  const double sum_bc = 1 - a, product_bc = C.trace() - a * sum_bc;
  if (!(product_bc > kMinWidthProduct * sum_bc * sum_bc)) return std::nullopt;
  // S - a has the eigenvalue zero for the normal n, so its cofactors are (b - a)(c - a) nnᵀ.
  S.diagonal().array() -= a;
  const Eigen::Matrix3d N = cofactors(S);
  if (!(N.trace() > kMinSeparation)) return std::nullopt;
  Eigen::Index widest;
  N.diagonal().maxCoeff(&widest);
  plane.normal = N.col(widest).normalized().cast<float>();
  if (!plane.normal.allFinite()) return std::nullopt;
  return plane;
}

}  // namespace quadrille
