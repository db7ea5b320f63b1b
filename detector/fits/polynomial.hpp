#pragma once

#include <vector>

namespace quadrille {

/// The real roots of a polynomial in ascending order; multiple roots occur repeatedly. Errors of
/// the coefficients split a double root by their square root, into two real roots or none;
/// `double_roots` finds it where it was, within the errors themselves.
/// @param coefficients  coefficients of 1, x, x², …; leading ones that are zero up to rounding are
///   dropped
/// @return empty for a constant, including zero, and for coefficients that are not finite
std::vector<double> real_roots(std::vector<double> coefficients);

/// The extrema of a polynomial at which it is zero up to errors of its coefficients.
/// @param noise  the errors in shares of the largest coefficient
std::vector<double> double_roots(const std::vector<double>& coefficients, double noise);

}  // namespace quadrille
