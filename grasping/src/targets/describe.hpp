#pragma once

#include "quadrille/grasping/grasp.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {

/// Turns an attempt that met no obstruction into a grasp, with its quality. As it is not measured
/// yet how well its space was seen, and its clearance, its score is what it would be if all space
/// were seen and nothing else were near, which is the most that it can be.
/// @param preshape  opening of the hand on its way in [m]
Grasp describe(const Attempt& attempt, double preshape, const TargetTask& task);

/// Measures how well the space of the fingers was seen, and sets the score of the grasp
/// accordingly.
void measure_seen(Grasp& grasp, const TargetTask& task);

/// Measures the clearance of a grasp, and sets its score accordingly.
void measure_clearance(Grasp& grasp, const TargetTask& task);

}  // namespace quadrille
