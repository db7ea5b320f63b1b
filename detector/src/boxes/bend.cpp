#include "boxes/bend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"
#include "samples/height_fit.hpp"

namespace quadrille {
namespace {

/// How far the normal turns across the places, along the main directions of the curvature.
/// @param H  second derivatives of the height [1/m]
double turn_across(const Eigen::Matrix2d& H, const std::vector<Eigen::Vector2d>& places) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(H);
  double turn = 0.0;
  for (int k = 0; k < 2; ++k) {
    std::vector<double> x;
    x.reserve(places.size());
    for (const Eigen::Vector2d& place : places) x.push_back(eigen.eigenvectors().col(k).dot(place));
    const double low = quantile(x, kTrimmed), width = quantile(x, 1.0 - kTrimmed) - low;
    turn = std::max(turn, std::abs(eigen.eigenvalues()[k]) * width);
  }
  return turn;
}

}  // namespace

Bend bend_of(const Face& face, const std::vector<Eigen::Vector3d>& measured_C) {
  if (measured_C.empty()) return {std::numeric_limits<double>::infinity()};
  const Eigen::Vector3d n = face.n_C, e1 = n.unitOrthogonal(), e2 = n.cross(e1);
  HeightFit fit;
  std::vector<Eigen::Vector2d> places;
  places.reserve(measured_C.size());
  for (const Eigen::Vector3d& p : measured_C) {
    const Eigen::Vector3d x = p - face.middle_C;
    places.emplace_back(x.dot(e1), x.dot(e2));
    fit.add(places.back().x(), places.back().y(), face.height(p));
  }
  const auto factor = fit.factor();
  const HeightFit::Vector6 a = factor.solve(fit.b);
  Eigen::Matrix2d H;
  H << 2 * a[3], a[4], a[4], 2 * a[5];
  // The sums of the fit hold the moments of the places.
  const double count = fit.A(0, 0);
  const Eigen::Vector2d mean = fit.A.block<2, 1>(1, 0) / count;
  const Eigen::Matrix2d S = fit.A.block<2, 2>(1, 1) / count - mean * mean.transpose();
  // The bulge -tr(HS) / 2 is linear in the coefficients.
  HeightFit::Vector6 terms;
  terms << 0.0, 0.0, 0.0, -S(0, 0), -S(0, 1), -S(1, 1);
  Bend bend;
  bend.turn = turn_across(H, places);
  bend.bulge = std::max(0.0, terms.dot(a));
  const double variance = kSharedNoise * fit.rss(a) / count * terms.dot(factor.solve(terms));
  bend.bulge_std = std::sqrt(std::max(0.0, variance));
  return bend;
}

}  // namespace quadrille
