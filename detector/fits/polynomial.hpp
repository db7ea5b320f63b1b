#pragma once

#include <vector>

namespace quadrille {

/// The real roots of a polynomial, ascending, multiple ones as often as they occur.
/// @param coefficients  of 1, x, x², …; leading ones that are zero but for rounding are dropped
/// @return empty for a constant, also for zero, and for coefficients that are not finite
std::vector<double> real_roots(std::vector<double> coefficients);

}  // namespace quadrille
