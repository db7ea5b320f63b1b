#pragma once

#include <vector>

#include "planes/planes.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// True if a curved surface bulges from one of the planes, reaches down to it, and is nowhere
/// steeper than 45° against it. Cloth, bags and grain lie so, since they slide where it is steeper.
/// The sides of solid things that stand or lie are steeper, at least at their foot.
/// @param samples  samples on which the surface was found
bool is_heap(const Surface& surface, const SurfaceSamples& samples,
             const std::vector<PlaneRegion>& planes);

}  // namespace quadrille
