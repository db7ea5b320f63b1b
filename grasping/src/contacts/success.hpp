#pragma once

#include "quadrille/grasping/grasp_terms.hpp"

namespace quadrille {

/// Returns the probability that a grasp succeeds: the logistic function of a weighted sum of its
/// terms. tools/lab/grasps/train_success.py learns the weights from grasps in simulated scenes,
/// some of them tried in a physics engine and the others judged on the true shapes.
double success_probability(const GraspTerms& terms);

}  // namespace quadrille
