#include "variants/close_distance.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// Singular values below this share of the largest count as zero; for exact cones, cylinders and
// planes they differ from zero only by rounding.
constexpr double kMinSingularShare = 1e-6;

/// Returns ‖A B⁺ − B B⁺‖.
double one_way(const Eigen::Matrix4d& A, const Eigen::Matrix4d& B) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> decomposition(4, 4);
  decomposition.setThreshold(kMinSingularShare);
  const Eigen::Matrix4d inverse = decomposition.compute(B).pseudoInverse();
  return ((A - B) * inverse).norm();
}

}  // namespace

double close_distance(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, double tau) {
  Vector10d qa = Quadric(a).normalized().coefficients();
  const Vector10d qb = Quadric(b).normalized().coefficients();
  if (qa.dot(qb) < 0) qa = -qa;
  if (!((qa - qb).lpNorm<1>() < tau)) return std::numeric_limits<double>::infinity();
  const Eigen::Matrix4d A = Quadric(qa).matrix(), B = Quadric(qb).matrix();
  return std::max(one_way(A, B), one_way(B, A));
}

}  // namespace quadrille
