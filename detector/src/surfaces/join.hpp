#pragma once

#include <optional>

#include "quadrille/detector/stage_options.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// True unless two regions lie so far apart that they have nothing to do with each other.
bool may_meet(const Normalisation& a, const Normalisation& b);

/// One surface in the place of two, without evidence; nullopt if no single quadric explains both as
/// well, by their residuals and by the Bayesian information criterion.
std::optional<Surface> join(const Surface& a, const Surface& b, const SurfaceSamples& samples,
                            const AggregateOptions& options);

}  // namespace quadrille
