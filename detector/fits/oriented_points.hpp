#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/oriented_point.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// The data of a fit: points xᵢ with normals nᵢ of the surface, one column each. Every fit takes
/// them in any frame and unit, and normalises them itself.
struct OrientedPoints {
  /// 3xN positions.
  Eigen::Matrix3Xd points;
  /// 3xN normals. Unit length, unless a fit says that it takes the gradient's length from them.
  Eigen::Matrix3Xd normals;

  explicit OrientedPoints(Eigen::Index size = 0) : points(3, size), normals(3, size) {}
  Eigen::Index size() const { return points.cols(); }
  OrientedPoint at(Eigen::Index i) const { return {points.col(i), normals.col(i)}; }
  /// The first of the columns.
  /// @throws std::invalid_argument if the numbers of points and normals differ
  OrientedPoints first(Eigen::Index count) const;
};

/// How far points must spread for a fit: at least along a line, over a plane, or in space.
enum class Spread { kLine = 1, kPlane = 2, kSpace = 3 };

/// Oriented points about their centroid in the unit ball (Hartley's normalisation, which the paper
/// asks for), and the way back.
struct NormalisedPoints {
  OrientedPoints data;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  /// Radius of the ball in the unit of the original points.
  double scale = 1.0;

  /// A quadric of the normalised points in the original frame, |q| = 1, its gradient on the side of
  /// the normals; nullopt if it is not finite, zero or a constant.
  std::optional<Quadric> undo(const Quadric& Q) const;
};

/// What happens to the lengths of normals: all become 1, or only their root mean square does.
enum class NormalLengths { kUnit, kAsGiven };

/// Moves oriented points into the unit ball.
/// @param least  least number of points that the fit needs
/// @return nullopt, that is "no solution", for fewer points, for NaN or infinite coordinates, for a
///         zero normal and for points without the needed spread (coincident, collinear, coplanar)
/// @throws std::invalid_argument if the numbers of points and normals differ
std::optional<NormalisedPoints> normalise(const OrientedPoints& points, Eigen::Index least,
                                          Spread spread,
                                          NormalLengths lengths = NormalLengths::kUnit);

/// The same surface with the gradient on the side of most normals.
Quadric oriented(const Quadric& Q, const OrientedPoints& points);

}  // namespace quadrille
