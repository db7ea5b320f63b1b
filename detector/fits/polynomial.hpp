#pragma once

#include <vector>

namespace quadrille {

/// The real roots of a polynomial in ascending order; multiple roots occur repeatedly.
/// @param coefficients  coefficients of 1, x, x², …; leading ones that are zero up to rounding are
///   dropped
/// @return empty for a constant, including zero, and for coefficients that are not finite
std::vector<double> real_roots(std::vector<double> coefficients);

}  // namespace quadrille
