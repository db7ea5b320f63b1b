#pragma once

#include "fit/posed_quadric.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A fit of one family.
struct FamilyFit {
  Family family = Family::kGeneral;
  PosedQuadric posed;
  /// Sum of squared first-order distances |f| / |∇f|, in the squared unit of the points.
  double rss = 0.0;
  /// Number of points.
  int points = 0;
};

}  // namespace quadrille
