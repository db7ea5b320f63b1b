#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille::experiments {

/// How far a fit is from the truth, means over the true points.
struct FitErrors {
  /// Distance from a true point to the fitted surface, in sizes of the quadric; 1 at most.
  double point = 0.0;
  /// 1 − n·∇f/|∇f|, the paper's negated dot product moved to 0.
  double angle = 0.0;
  /// | |∇f| / mean |∇f| − |∇f*| / mean |∇f*| | with the true quadric f*: the length of a gradient
  /// is known up to a common factor. 1 at most.
  double gradient = 0.0;
};

/// Errors of a fit on exact points and normals; those of no fit are 1 each.
/// @param size  of the quadric, in the unit of the points
FitErrors errors_of(const std::optional<Quadric>& fit, const Quadric& truth,
                    const OrientedPointsd& points, double size);

}  // namespace quadrille::experiments
