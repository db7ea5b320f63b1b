#pragma once

#include <vector>

#include "planes/planes.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Per finest cell, the plane that it lies on, next to where the plane was found: the nearest, of
/// several; −1 for none.
/// @param coarse  the samples that the planes were found on
/// @param sigmas  largest distance in multiples of the cells' noise
std::vector<int> planes_of_cells(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                 const std::vector<PlaneRegion>& planes, double sigmas);

/// Per finest cell, zero if it lies on a plane, as nothing else is looked for there.
/// @param plane_of_cell  as planes_of_cells() gives it
std::vector<char> cells_off_planes(const std::vector<int>& plane_of_cell);

}  // namespace quadrille
