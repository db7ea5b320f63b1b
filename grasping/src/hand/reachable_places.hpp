#pragma once

#include <Eigen/Geometry>

#include "quadrille/grasping/reach.hpp"

namespace quadrille {

/// Returns false if an arm reaches none of the places of a box. A box that overlaps the reach of
/// the arm in no point may still count as reached, but never the other way round.
/// @param places  positions in the axes of X_CP [m]
bool may_reach(const Reach& reach, const Eigen::Isometry3d& X_CP,
               const Eigen::AlignedBox3d& places);

/// Returns false if an arm can bring the hand to none of the places of a box, or to none of the
/// places from which the hand starts its straight approach there; for a box of one point this is
/// exact.
/// @param places_G  displacements of the hand from X_CG, in the axes of G [m]
/// @param approach  length of the straight approach [m]
bool may_approach(const Reach& reach, const Eigen::Isometry3d& X_CG,
                  const Eigen::AlignedBox3d& places_G, double approach);

}  // namespace quadrille
