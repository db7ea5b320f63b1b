#pragma once

#include "quadrille/grasping/grasp_terms.hpp"
#include "targets/hand_trials.hpp"

namespace quadrille {

/// Returns the terms of an attempt, as if all of its space were seen and nothing else were near.
/// @param preshape  opening of the hand on its way in [m]
GraspTerms terms_of(const Attempt& attempt, double preshape, const TargetTask& task);

/// Returns the score that an attempt has at best: with the hand wide open on its way in, all of its
/// space seen and nothing else near. This bound takes little to compute, so that an attempt that
/// would score too little is refused before anything else is checked.
double best_score(const Attempt& attempt, const TargetTask& task);

/// Returns the score that a grasp of the target's shape, across it or by the tips, has at best.
/// @param std  standard deviation of half the target's width where it is held [m]
double best_shape_score(double std, const TargetTask& task);

/// Returns false if the target is so far away that, by experience with 148 targets, a hold by
/// points is hardly ever likely enough.
bool near_enough_for_points(const Target& target, const SceneParts& parts, double min_score);

}  // namespace quadrille
