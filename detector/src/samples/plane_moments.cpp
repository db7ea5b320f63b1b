#include "samples/plane_moments.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace quadrille {
namespace {

constexpr float kMinPoints = 4;
// Narrower than this share of its length, and what the points lie on is a line: as a ratio of
// eigenvalues, and as the product of two with that ratio over their squared sum.
constexpr double kNarrow = 0.05, kNarrowProduct = kNarrow / ((1 + kNarrow) * (1 + kNarrow));
// Of eigenvalues that sum to one: where the sum of their products in pairs is less, the points lie
// on a line; where the two larger ones' distances from the least multiply to less, all are alike.
constexpr double kLine = 1e-3, kRound = 1e-6;
constexpr int kSteps = 20;
constexpr double kConverged = 1e-9;

/// The least root of λ³ − λ² + bλ − c, whose roots are real and not negative: from zero Newton's
/// steps climb to it and never past it.
double min_root(double b, double c) {
  double root = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double slope = (3 * root - 2) * root + b;
    if (!(slope > kConverged)) break;
    const double step = (((root - 1) * root + b) * root - c) / slope;
    root -= step;
    if (std::abs(step) < kConverged) break;
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

bool PlaneMoments::solve(Eigen::Vector3f* mean, Eigen::Vector3f* normal) const {
  if (n < kMinPoints) return false;
  *mean = sum / n;
  const Eigen::Vector3d m = mean->cast<double>();
  const Eigen::Vector3d ii = squares.matrix().cast<double>() / static_cast<double>(n);
  const Eigen::Vector3d ij = products.matrix().cast<double>() / static_cast<double>(n);
  Eigen::Matrix3d S;
  S << ii[0], ij[0], ij[2], ij[0], ii[1], ij[1], ij[2], ij[1], ii[2];
  S -= m * m.transpose();
  const double trace = S.trace();
  if (!(trace > 0)) return false;
  S /= trace;
  const Eigen::Matrix3d C = cofactors(S);
  if (!(C.trace() > kLine)) return false;
  const double least = min_root(C.trace(), S.col(0).dot(C.col(0)));
  const double others = 1 - least;
  if (!(C.trace() - least * others > kNarrowProduct * others * others)) return false;
  // The cofactors of S − λ are nnᵀ times the product of the other eigenvalues of that.
  S.diagonal().array() -= least;
  const Eigen::Matrix3d N = cofactors(S);
  if (!(N.trace() > kRound)) return false;
  Eigen::Index widest;
  N.diagonal().maxCoeff(&widest);
  *normal = N.col(widest).normalized().cast<float>();
  return normal->allFinite();
}

}  // namespace quadrille
