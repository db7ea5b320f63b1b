#pragma once

namespace quadrille {

/// Number of bases after which, with a given confidence, one consists only of points on the
/// surface: the least n with 1 − (1 − wᵏ)ⁿ ≥ confidence (Fischler and Bolles, 1981).
/// @param w  share of the points that lie on the surface, 0 to 1
/// @param k  number of points in a basis
/// @return infinite for w = 0
double bases_needed(double w, int k, double confidence);

}  // namespace quadrille
