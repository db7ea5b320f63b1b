#pragma once

#include <vector>

#include "planes/planes.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Finest cells that lie on one of the planes, next to where the plane was found: zero in the
/// result, as nothing else is looked for there.
/// @param coarse  the samples that the planes were found on
/// @param sigmas  largest distance in multiples of the cells' noise
std::vector<char> cells_off_planes(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                   const std::vector<PlaneRegion>& planes, double sigmas);

}  // namespace quadrille
