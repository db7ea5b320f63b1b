#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <optional>

#include "base/random.hpp"
#include "fits/normalise.hpp"

namespace quadrille {

/// A quadric through a minimal set of points.
struct MinimalFit {
  Quadric Q;
  /// The shift of the surface that rounded coordinates and normals lead one to expect, in radii of
  /// the points. It is estimated; where the gradient is short, as beside an apex, more is possible.
  double error = 0.0;
};

/// Fits of which more is to be expected are refused.
inline constexpr double kMaxRoundingError = 8e-10;

/// The error that rounding leaves in a closed form: the form is evaluated thrice with data
/// displaced along fixed random directions (Kenney and Laub's small-sample estimate of the
/// condition).
/// @param solve  from normalised points to std::optional<Eigen::Matrix4d>, its gradients about one
///               long
/// @return nullopt if there is no solution, there or a little beside
template <class Solve>
std::optional<MinimalFit> fit_with_error(const NormalisedPoints& points, Eigen::Index oriented,
                                         const Solve& solve) {
  constexpr double kStep = 1e-8;
  const std::optional<Eigen::Matrix4d> best = solve(points.data);
  if (!best || !best->allFinite()) return std::nullopt;
  double largest = 0.0;
  RandomStream random(0, 0);
  const auto displace = [&](double& value) { value += kStep * (2.0 * random.uniform() - 1.0); };
  for (int trial = 0; trial < 3; ++trial) {
    OrientedPointsd beside = points.data;
    for (double& value : beside.points.reshaped()) displace(value);
    for (double& value : beside.normals.leftCols(oriented).reshaped()) displace(value);
    const std::optional<Eigen::Matrix4d> other = solve(beside);
    if (!other || !other->allFinite()) return std::nullopt;
    largest = std::max(largest, (*other - *best).norm());
  }
  const auto& [centre, scale] = points.local;
  const double rounding = std::numeric_limits<double>::epsilon() * (1.0 + centre.norm() / scale);
  const double error = largest / kStep * rounding;
  if (!(error <= kMaxRoundingError)) return std::nullopt;
  const std::optional<Quadric> Q = points.undo(Quadric(*best));
  if (!Q) return std::nullopt;
  return MinimalFit{*Q, error};
}

}  // namespace quadrille
