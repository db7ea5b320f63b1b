#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "fit/family_fit.hpp"
#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "surfaces/lid_outline.hpp"

namespace quadrille {

/// The wall of a cylinder, in local coordinates.
struct Wall {
  /// Round or elliptic cylinder that was fitted to the wall alone.
  FamilyFit fit;
  OrientedPointsf points;
  /// Number of independent measurements on which that fit rests, and the standard deviation of the
  /// noise that all points have in common; see SelectionOptions.
  double effective_size;
  double common_noise;
};

/// The outline in local coordinates.
std::vector<OutlinePoint> local_outline(std::span<const OutlinePoint> outline,
                                        const Normalisation& local);

/// A fit to a wall and the outline of its lid, and the points of both. The sum of squares of the
/// fit is that of the wall alone, scaled to the number of all points.
struct ClosedFit {
  FamilyFit fit;
  OrientedPointsf points;
  /// Standard deviation of what the points of the outline may be off together.
  double common_error;
};

/// Fits a round and an elliptic cylinder to a wall and the outline of its lid, and chooses by the
/// Bayesian information criterion, as FamilyFits::select() does.
///
/// The wall alone leaves open how its section closes if little of it is seen: a circle of twice the
/// radius explains a quarter of an ellipse. A point of the outline counts as one of the wall. It is
/// less exact, but points of the wall share their noise with their neighbours.
/// @return nullopt if no cylinder runs through both, so that the lid is not that of the wall
std::optional<ClosedFit> fit_closed(const Wall& wall, const std::vector<OutlinePoint>& outline);

}  // namespace quadrille
