#pragma once

#include "samples/depth/noise.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Noise of the voxels' means [m], as the residual of quadratic heights over planes: a quantile
/// over patches spread over the grid. A millimetre if there are too few patches to tell.
float measure_voxel_noise(const VoxelGrid& grid, const NoiseOptions& options);

}  // namespace quadrille
