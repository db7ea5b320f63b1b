#pragma once

#include <span>

#include "quadrille/detector/canonical.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"

namespace quadrille {

/// Where a quadric would have to be seen, all around its axis as far as a region reaches along it,
/// the share of the rays that see something behind it: 0 to 1. A ball that is a bump on something
/// else would hide what is seen beside it. Spheres and ellipsoids reach as far as their region does
/// along the up direction, where that is known; what has no closed cross section reaches no farther
/// than its region.
/// @param region  not empty
/// @param form    of Q; its axes in frame C
/// @return 0 without rays
double see_through(const SceneContext& context, const SurfaceSamples& samples,
                   std::span<const int> region, const Quadric& Q, const CanonicalForm& form);

}  // namespace quadrille
