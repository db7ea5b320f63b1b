#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "surfaces/lid.hpp"

namespace quadrille {

/// A place where a view saw a lid end.
struct OutlinePoint {
  Eigen::Vector3d p_C;
  /// Standard deviation across the outline [m].
  double std;
};

/// Finds the outline of a lid where it is a true edge: from the middle outwards, the sensor saw the
/// lid and directly beyond it something behind. No point is returned where something nearer hides
/// the edge, where nothing was seen beside it, or where the wall below it faces the sensor, since
/// there the wall's own points show the edge better.
///
/// The lid is divided into sectors. In each, the edge lies halfway between the last point on the
/// lid and the first one of what is seen behind it, both projected along their rays onto the lid's
/// plane. Points at depths between the two, which sensors measure along edges, are passed over.
/// @param points_C  what was seen in the direction of the lid and around it
/// @param eye_C     the viewpoint
std::vector<OutlinePoint> outline_of(const Lid& lid, std::span<const Eigen::Vector3d> points_C,
                                     const Eigen::Vector3d& eye_C);

}  // namespace quadrille
