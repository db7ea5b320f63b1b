#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

struct DistanceFitOptions {
  /// Largest number of Gauss-Newton steps.
  int iterations = 50;
};

/// Least squares of the first-order (Sampson) distance f / |∇f| from the best closed-form fit. It
/// runs the detector's own refine() (fit/geometric_fit.hpp) in the general family, in double
/// precision and to convergence.
/// @param points  at least 9; normals help to choose the start and the gradient's side
/// @return nullopt if the points are too few, coplanar, or give no start
std::optional<Quadric> fit_first_order_distance(const OrientedPointsd& points,
                                                const DistanceFitOptions& options = {});

/// Least squares of the true distance to the surface, by orthogonal projection of each point and
/// damped Gauss-Newton steps (the paper's footnote on non-linear refinement; S. J. Ahn, W. Rauh,
/// H.-J. Warnecke, "Least-squares orthogonal distances fitting of circle, sphere, ellipse,
/// hyperbola, and parabola", Pattern Recognition 2001). If y is the foot of x, dd/dq = v(y) /
/// |∇f(y)|.
/// @param points  at least 9; normals help to choose the start and the gradient's side
/// @return nullopt if the points are too few, coplanar, or give no start
std::optional<Quadric> fit_orthogonal_distance(const OrientedPointsd& points,
                                               const DistanceFitOptions& options = {});

}  // namespace quadrille
