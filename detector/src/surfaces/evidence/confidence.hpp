#pragma once

#include <string_view>

#include "surfaces/evidence/confidence_model.hpp"
#include "surfaces/evidence/evidence.hpp"

namespace quadrille {

/// Selects the model that weighs a surface.
enum class SurfaceKind { kCurved, kFlat };

/// Returns the evidence as inputs of the models, in the order of kConfidenceTerms.
/// @param dof        degrees of freedom of the quadric's family
/// @param log_prior  log_prior() of the quadric's type
ConfidenceTerms confidence_terms(const Evidence& evidence, int dof, double log_prior);

/// Probability, 0 to 1, that a quadric with these terms is a real and separate surface: a logistic
/// model whose log odds are a sum of weighted terms and products of two, trained on scenes with
/// known truth.
double confidence(const ConfidenceTerms& terms, SurfaceKind kind);

/// The highest confidence() over all values of one of the terms.
/// @param unknown  name of the term, of kConfidenceTerms
double highest_confidence(ConfidenceTerms terms, std::string_view unknown, SurfaceKind kind);

}  // namespace quadrille
