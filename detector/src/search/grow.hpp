#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/marks.hpp"
#include "base/mask.hpp"
#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/candidate.hpp"

namespace quadrille {

/// Grows a hypothesis over connected inliers and refits it, in turn, until it settles. A refit
/// selects the simplest family that explains the region, since ten free coefficients from a small
/// patch would mislead the growth, and keeps the family until the region's size has changed
/// considerably.
/// @param start  samples to begin with
/// @param free   samples that it may grow over
/// @param seen   buffer, of the size of the samples
/// @return nullopt if the region becomes too small or has no fit
std::optional<Candidate> grow(const SurfaceSamples& samples, const Quadric& hypothesis,
                              std::span<const int> start, const Mask& free,
                              const InlierTest& inlier, const GrowOptions& options, Marks* seen);

}  // namespace quadrille
