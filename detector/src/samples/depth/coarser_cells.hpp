#pragma once

#include "base/mask.hpp"
#include "samples/depth/depth_cells.hpp"

namespace quadrille {

/// Makes cells of twice the edge, each of up to four finer ones. A cell that would span a depth
/// edge keeps only those of the finer ones whose depth continues that of the middle one.
/// @param keep  nonzero for the finer cells to use; empty: all of them
DepthCells coarser(const DepthCells& fine, const Mask& keep);

}  // namespace quadrille
