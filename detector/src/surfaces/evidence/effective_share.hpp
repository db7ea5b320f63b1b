#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Independent measurements per sample, 0 to 1, if neighbouring residuals have this correlation ρ;
/// 1 if it is negative: ((1 − ρ) / (1 + ρ))², as for noise whose correlation decays exponentially
/// along two axes. The noise of depth sensors comes in waves, so many samples carry less
/// information than they seem to.
double effective_share(double correlation);

/// The same, given the quadric from which the residuals are.
double effective_share(const SurfaceSamples& samples, std::span<const int> region,
                       const Quadric& Q);

}  // namespace quadrille
