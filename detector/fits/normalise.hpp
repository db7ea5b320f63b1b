#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// The spread of points that a fit needs: along a line, over a plane, or in space.
enum class Spread { kLine = 1, kPlane = 2, kSpace = 3 };

/// Oriented points around their centroid in the unit ball, and the map back.
struct NormalisedPoints {
  OrientedPointsd data;
  Normalisation local;

  /// The rounding error that the coordinates have already, far from the origin more than 2e-16.
  double rounding() const;

  /// Transforms a quadric of the normalised points to the original frame, with |q| = 1 and the
  /// gradient on the side of the normals; nullopt if it is not finite, zero or a constant.
  std::optional<Quadric> undo(const Quadric& Q) const;
};

/// Treatment of the normals' lengths: all are set to 1, or only scaled such that their root mean
/// square is 1.
enum class NormalLengths { kUnit, kAsGiven };

/// Moves oriented points into the unit ball. Every fit calls this itself, so that it accepts points
/// in any frame and unit.
/// @param min_size  number of points that the fit needs
/// @return nullopt, which means "no solution", for fewer points, for NaN or infinite coordinates,
///   for a zero normal, and for points without the needed spread (coincident, collinear, coplanar)
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<NormalisedPoints> normalise(const OrientedPointsd& points, Eigen::Index min_size,
                                          Spread spread,
                                          NormalLengths lengths = NormalLengths::kUnit);

/// Returns the same surface with its gradient on the side of most normals.
Quadric oriented(const Quadric& Q, const OrientedPointsd& points);

}  // namespace quadrille
