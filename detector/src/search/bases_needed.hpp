#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Points that a basis is drawn of.
int basis_size(BasisKind kind);

/// Bases after which one of points on the surface alone has been drawn, with a confidence: the
/// least n with 1 − (1 − wᵏ)ⁿ ≥ confidence (Fischler and Bolles, 1981).
/// @param w  share of the points that lie on the surface, 0 to 1
/// @param k  points a basis
/// @return infinite for w = 0
double bases_needed(double w, int k, double confidence);

}  // namespace quadrille
