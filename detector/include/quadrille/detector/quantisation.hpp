#pragma once

namespace quadrille {

/// How a vote's parameter λ in (−∞, ∞) is carried to a bounded place for its bin (paper,
/// "Quantizing λ").
enum class Quantisation {
  kArctangent,  ///< atan(λ / λ₀), the angle that the paper's footnote names
  kMeasured,    ///< the inverse of the measured distribution of λ: bins of equal mass
};

/// Place of λ from 0 to 1.
/// @param scale  λ₀ of the arctangent
float place_of(Quantisation quantisation, float lambda, float scale);

/// The inverse: λ of a place between 0 and 1, both left out.
float lambda_at(Quantisation quantisation, float place, float scale);

}  // namespace quadrille
