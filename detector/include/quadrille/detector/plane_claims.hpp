#pragma once

#include <vector>

#include "quadrille/detector/aggregate.hpp"
#include "quadrille/detector/cell_pyramid.hpp"
#include "quadrille/detector/planes.hpp"

namespace quadrille {

/// Finest cells that lie on one of the planes, next to where the plane was found: zero in the
/// result, as nothing else is looked for there.
/// @param coarse  the samples that the planes were found on
/// @param sigmas  largest distance in multiples of the cells' noise
std::vector<char> cells_off_planes(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                   const std::vector<PlaneRegion>& planes, double sigmas);

/// A plane as a surface, so that it is measured like all others.
/// @param samples  the samples that the plane was found on
Surface plane_surface(const SurfaceSamples& samples, const PlaneRegion& plane);

/// True if most of a flat surface lies within a few sigma of one of the planes and parallel to it:
/// a strip of table or wall that waves in the noise had cut off.
bool is_part_of(const Surface& flat, const SurfaceSamples& samples,
                const std::vector<PlaneRegion>& planes);

}  // namespace quadrille
