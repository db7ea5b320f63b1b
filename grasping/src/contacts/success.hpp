#pragma once

#include "quadrille/grasping/grasp_terms.hpp"

namespace quadrille {

/// Returns the probability that a grasp succeeds. A weighted sum of its terms ranks grasps; the
/// logistic function of a slope times that sum plus an offset is the probability (Platt, 1999).
/// tools/lab/grasps/train_success.py learns the weights, and calibration.py beside it then learns
/// the slope and the offset, from grasps in simulated scenes, some of them tried in a physics
/// engine and the others judged on the true shapes.
double success_probability(const GraspTerms& terms);

}  // namespace quadrille
