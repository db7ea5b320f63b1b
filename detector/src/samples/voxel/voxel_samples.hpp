#pragma once

#include <vector>

#include "samples/surface_samples.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Surface samples of a cloud fused from several views: around each voxel, a plane is fitted to the
/// voxels' means by principal components, with its normal towards the eye.
/// @param keep   per voxel, zero to leave it out of all windows
/// @param sigma  noise of the voxels' means [m]
/// @param eye    viewpoint in frame C [m]
/// @param reach  radius of the neighbourhood in voxels
SurfaceSamples make_voxel_samples(const VoxelGrid& grid, const std::vector<char>& keep, float sigma,
                                  const Eigen::Vector3f& eye, float reach);

}  // namespace quadrille
