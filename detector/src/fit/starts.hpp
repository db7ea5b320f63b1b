#pragma once

#include <optional>
#include <vector>

#include "fit/closed_form/point_moments.hpp"
#include "fit/family_fit.hpp"
#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// Closed-form starts for fits to one set of points.
class Starts {
 public:
  explicit Starts(const OrientedPointsf& points) : moments_(points) {}

  /// Starts for one family; `known` are the fits so far, on which some starts build.
  std::vector<PosedQuadric> of(Family family, const std::vector<FamilyFit>& known);

 private:
  const std::optional<PosedQuadric>& revolution();

  PointMoments moments_;
  /// Three families use this start, so it is computed once.
  std::optional<std::optional<PosedQuadric>> revolution_;
};

}  // namespace quadrille
