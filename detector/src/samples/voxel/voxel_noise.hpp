#pragma once

#include "samples/depth/noise.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Noise of the voxels' means [m], as a quantile of the residuals of quadratic heights over planes,
/// in patches spread over the grid. It is a millimetre if there are too few patches.
float measure_voxel_noise(const VoxelGrid& grid, const NoiseOptions& options);

}  // namespace quadrille
