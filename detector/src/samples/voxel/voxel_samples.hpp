#pragma once

#include <vector>

#include "samples/surface_samples.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Surface samples of a cloud from many sides: the plane through the voxels' means around each
/// voxel by principal components, its normal turned towards the eye.
/// @param keep   per voxel, zero to leave it out of everything
/// @param sigma  noise of the voxels' means [m]
/// @param eye    viewpoint in frame C [m]
/// @param reach  radius of the neighbourhood, in voxels
SurfaceSamples make_voxel_samples(const VoxelGrid& grid, const std::vector<char>& keep, float sigma,
                                  const Eigen::Vector3f& eye, float reach);

}  // namespace quadrille
