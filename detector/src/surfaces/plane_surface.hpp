#pragma once

#include <vector>

#include "planes/planes.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/scene_context.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Converts a plane to a surface, so that it is measured like all others.
/// @param samples  the samples on which the plane was found
Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane);

/// Converts planes to surfaces, each with its evidence and confidence as if nothing else had been
/// found.
/// @param samples  the samples on which the planes were found
std::vector<Surface> weighed_planes(const SurfaceSamples& samples,
                                    const std::vector<PlaneRegion>& planes,
                                    const SceneContext& context);

/// True if most of a flat surface lies within a few sigma of one of the planes and parallel to it:
/// a strip of a table or wall that noise waves have cut off.
/// @param samples  samples on which the surface was found
/// @param coarse   samples on which the planes were found
bool is_part_of(const Surface& flat, const SurfaceSamples& samples,
                const std::vector<PlaneRegion>& planes, const SurfaceSamples& coarse);

}  // namespace quadrille
