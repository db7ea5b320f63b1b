#pragma once

#include "quadrille/grasping/grasp.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {

/// Returns true if the surface was measured next to a contact.
bool was_seen(const Eigen::Vector3d& contact_C, const OccupancyGrid& space);

/// Turns an attempt that met no obstruction into a grasp, with its quality and score.
/// @param preshape  opening of the hand on its way in [m]
Grasp describe(const Attempt& attempt, double preshape, const TargetTask& task);

}  // namespace quadrille
