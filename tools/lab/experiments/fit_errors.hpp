#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille::experiments {

/// Errors of a fit, averaged over the true points.
struct FitErrors {
  /// Distance from a true point to the fitted surface, relative to the size of the quadric; at most
  /// 1.
  double point = 0.0;
  /// 1 − n·∇f/|∇f|, the paper's negated dot product shifted so that 0 is best.
  double angle = 0.0;
  /// | |∇f| / mean |∇f| − |∇f*| / mean |∇f*| | with the true quadric f*, since gradient lengths are
  /// known only up to a common factor; at most 1.
  double gradient = 0.0;
};

/// Returns the errors of a fit at exact points and normals; each is 1 if there is no fit.
/// @param size  size of the quadric, in the unit of the points
FitErrors errors_of(const std::optional<Quadric>& fit, const Quadric& truth,
                    const OrientedPointsd& points, double size);

}  // namespace quadrille::experiments
