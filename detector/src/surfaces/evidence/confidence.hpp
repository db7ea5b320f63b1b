#pragma once

#include <array>

#include "surfaces/evidence/confidence_model.hpp"
#include "surfaces/evidence/evidence.hpp"

namespace quadrille {

/// Which model weighs a surface.
enum class SurfaceKind { kCurved, kFlat };

/// The evidence as the models weigh it, in the order of kConfidenceTerms.
/// @param dof        degrees of freedom of the quadric's family
/// @param log_prior  of its type; see log_prior()
std::array<double, kConfidenceTerms.size()> confidence_terms(const Evidence& evidence, int dof,
                                                             double log_prior);

/// Probability that a quadric with these terms is a real surface of its own, 0 to 1: a logistic
/// model whose log odds are quadratic in the terms, trained on scenes of which all is known.
double confidence(const std::array<double, kConfidenceTerms.size()>& terms, SurfaceKind kind);

}  // namespace quadrille
