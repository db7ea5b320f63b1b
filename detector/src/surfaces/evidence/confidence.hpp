#pragma once

#include <array>

#include "surfaces/evidence/confidence_weights.hpp"
#include "surfaces/evidence/evidence.hpp"

namespace quadrille {

/// The evidence in the form in which it adds to the log odds, in the order of kConfidenceWeights.
/// @param dof  degrees of freedom of the quadric's family
std::array<double, kConfidenceWeights.size()> confidence_terms(const Evidence& evidence, int dof);

/// Confidence that a curved quadric with this evidence is a real surface of its own, 0 to 1: a
/// logistic model over the evidence, to which the type's prior is added; see log_prior().
double confidence(const Evidence& evidence, int dof, double log_prior = 0.0);

}  // namespace quadrille
