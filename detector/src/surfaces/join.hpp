#pragma once

#include <optional>

#include "quadrille/detector/stage_options.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// False if two regions are so far apart that they cannot belong to one surface.
bool may_meet(const Normalisation& a, const Normalisation& b);

/// Returns one surface in place of two, without evidence. Nullopt if no single quadric explains
/// both as well, judged by residuals and by the Bayesian information criterion.
std::optional<Surface> join(const Surface& a, const Surface& b, const SurfaceSamples& samples,
                            const AggregateOptions& options);

}  // namespace quadrille
