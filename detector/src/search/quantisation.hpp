#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Place of λ from 0 to 1.
/// @param scale  λ₀ of the arctangent
float place_of(Quantisation quantisation, float lambda, float scale);

/// The inverse: λ of a place between 0 and 1, both left out.
float lambda_at(Quantisation quantisation, float place, float scale);

}  // namespace quadrille
