#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Maps λ to a position between 0 and 1.
/// @param scale  λ₀ of the arctangent
float place_of(Quantisation quantisation, float lambda, float scale);

/// Maps a position strictly between 0 and 1 back to λ, the inverse of place_of().
float lambda_at(Quantisation quantisation, float place, float scale);

}  // namespace quadrille
