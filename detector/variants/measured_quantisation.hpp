#pragma once

#include "search/vote_histogram.hpp"

namespace quadrille {

/// The measured distribution function of λ, which gives bins of equal mass.
extern const Quantisation kMeasured;

}  // namespace quadrille
