#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// How far points must spread for a fit: at least along a line, over a plane, or in space.
enum class Spread { kLine = 1, kPlane = 2, kSpace = 3 };

/// Oriented points about their centroid in the unit ball, and the way back.
struct NormalisedPoints {
  OrientedPointsd data;
  Normalisation local;

  /// A quadric of the normalised points in the original frame, |q| = 1, its gradient on the side of
  /// the normals; nullopt if it is not finite, zero or a constant.
  std::optional<Quadric> undo(const Quadric& Q) const;
};

/// What happens to the lengths of normals: all become 1, or only their root mean square does.
enum class NormalLengths { kUnit, kAsGiven };

/// Moves oriented points into the unit ball: every fit takes them in any frame and unit, and calls
/// this itself.
/// @param min_size  number of points that the fit needs
/// @return nullopt, that is "no solution", for fewer points, for NaN or infinite coordinates, for a
///         zero normal and for points without the needed spread (coincident, collinear, coplanar)
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<NormalisedPoints> normalise(const OrientedPointsd& points, Eigen::Index min_size,
                                          Spread spread,
                                          NormalLengths lengths = NormalLengths::kUnit);

/// The same surface with the gradient on the side of most normals.
Quadric oriented(const Quadric& Q, const OrientedPointsd& points);

}  // namespace quadrille
