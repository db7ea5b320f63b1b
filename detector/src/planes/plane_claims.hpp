#pragma once

#include <vector>

#include "base/mask.hpp"
#include "planes/planes.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Returns for each finest cell the index of the nearest plane on which it lies, or −1 for none. A
/// cell can lie on a plane only where, or next to where, that plane was found.
/// @param coarse  samples on which the planes were found
/// @param sigmas  largest distance in multiples of the cell's noise
/// @param threads  number of threads, each for some of the cells; it never changes the result
std::vector<int> planes_of_cells(const CellPyramid& pyramid, const SurfaceSamples& coarse,
                                 const std::vector<PlaneRegion>& planes, double sigmas,
                                 int threads = 1);

/// Returns the finest cells that lie on no plane; other surfaces are sought only there.
/// @param plane_of_cell  result of planes_of_cells()
Mask cells_off_planes(const std::vector<int>& plane_of_cell);

}  // namespace quadrille
