#pragma once

#include <vector>

#include "planes/planes.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// A plane as a surface, so that it is measured like all others.
/// @param samples  the samples that the plane was found on
Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane);

/// True if most of a flat surface lies within a few sigma of one of the planes and parallel to it:
/// a strip of table or wall that waves in the noise had cut off.
bool is_part_of(const Surface& flat, const SurfaceSamples& samples,
                const std::vector<PlaneRegion>& planes);

}  // namespace quadrille
