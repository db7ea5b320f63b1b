#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "base/random.hpp"
#include "fits/normalise.hpp"

namespace quadrille {

/// A quadric through a minimal set of points.
struct MinimalFit {
  Quadric Q;
  /// Estimated shift of the surface near its points due to rounding of coordinates and normals, in
  /// radii of the points. It may be larger where the gradient is shorter, as near an apex.
  double error = 0.0;
};

/// A fit with a larger estimated error is refused.
inline constexpr double kMaxRoundingError = 8e-10;

/// Solves a closed form and estimates the error that rounding leaves in it: the form is evaluated
/// three times with data displaced in fixed random directions (Kenney and Laub's small-sample
/// estimate of the condition).
/// @param solve  maps normalised points to std::optional<Eigen::Matrix4d>, whose gradients have a
///   length of about one
/// @return nullopt if there is no solution for the data or for slightly displaced data
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
  const double error = largest / kStep * points.rounding();
  if (!(error <= kMaxRoundingError)) return std::nullopt;
  const std::optional<Quadric> Q = points.undo(Quadric(*best));
  if (!Q) return std::nullopt;
  return MinimalFit{*Q, error};
}

}  // namespace quadrille
