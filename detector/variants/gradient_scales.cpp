#include "variants/gradient_scales.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// A noisy basis is not voted on if one gradient is shorter than another by this factor.
constexpr double kMinRatio = 0.1;

/// A pair of points of a basis, with the products of their normals and the unit vector between
/// them.
struct Pair {
  int i, j;
  double b_ij, b_ji;

  double strength() const { return std::min(std::abs(b_ij), std::abs(b_ji)); }
};

std::optional<std::array<Pair, 3>> pairs_of(const std::array<OrientedPoint, 3>& basis) {
  std::array<Pair, 3> pairs;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Eigen::Vector3d e = basis[j].x - basis[i].x;
    const double length = e.norm();
    if (!(length > 0.0)) return std::nullopt;
    pairs[i] = {i, j, basis[i].n.dot(e) / length, -basis[j].n.dot(e) / length};
  }
  return pairs;
}

/// Computes α from the two strongest pairs, which have one point in common.
Eigen::Vector3d exact_scales(std::array<Pair, 3> pairs) {
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return a.strength() > b.strength(); });
  if (!(pairs[1].strength() > 0.0)) return Eigen::Vector3d::Zero();
  const int common = 3 - pairs[2].i - pairs[2].j;
  Eigen::Vector3d alpha = Eigen::Vector3d::Ones();
  for (int k = 0; k < 2; ++k) {
    const Pair& p = pairs[k];
    if (p.i == common) {
      alpha[p.j] = p.b_ij / p.b_ji;
    } else {
      alpha[p.i] = p.b_ji / p.b_ij;
    }
  }
  return alpha;
}

Eigen::Vector3d soft_scales(const std::array<Pair, 3>& pairs, double softness) {
  const double prior = softness * softness;
  Eigen::Matrix3d sums = prior * Eigen::Matrix3d::Identity();
  for (const Pair& p : pairs) {
    sums(p.i, p.i) += p.b_ij * p.b_ij;
    sums(p.j, p.j) += p.b_ji * p.b_ji;
    sums(p.i, p.j) -= p.b_ij * p.b_ji;
    sums(p.j, p.i) -= p.b_ij * p.b_ji;
  }
  return sums.inverse() * Eigen::Vector3d::Constant(prior);
}

/// Returns the basis with its normals scaled to the lengths α.
std::array<OrientedPoint, 3> with_lengths(std::array<OrientedPoint, 3> basis,
                                          const std::array<double, 3>& lengths) {
  for (std::size_t i = 0; i < 3; ++i) basis[i].n *= lengths[i];
  return basis;
}

}  // namespace

std::optional<std::array<double, 3>> gradient_scales(const std::array<OrientedPoint, 3>& basis,
                                                     double softness) {
  const auto pairs = pairs_of(basis);
  if (!pairs) return std::nullopt;
  const bool exact = softness == 0.0;
  const Eigen::Vector3d alpha = exact ? exact_scales(*pairs) : soft_scales(*pairs, softness);
  const double least = exact ? 0.0 : kMinRatio * alpha.maxCoeff();
  if (!(alpha.minCoeff() > least)) return std::nullopt;
  const double mean = alpha.mean();
  return std::array<double, 3>{alpha[0] / mean, alpha[1] / mean, alpha[2] / mean};
}

std::optional<Pencil> make_scaled_pencil(const std::array<OrientedPoint, 3>& basis, double softness,
                                         double min_area_share) {
  const auto lengths = gradient_scales(basis, softness);
  if (!lengths) return std::nullopt;
  return make_pencil(with_lengths(basis, *lengths), min_area_share);
}

}  // namespace quadrille
