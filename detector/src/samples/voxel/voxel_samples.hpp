#pragma once

#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"
#include "samples/voxel/voxel_grid.hpp"

namespace quadrille {

/// Radius in voxels within which voxels are neighbours. It includes all that touch by a face, an
/// edge or a corner, if their means are as far apart as their middles.
inline constexpr float kNeighbourReach = 1.9f;

/// Surface samples of a cloud fused from several views: around each voxel, a plane is fitted to the
/// voxels' means by principal components, with its normal towards the eye.
/// @param keep   voxels to use, in windows too
/// @param sigma  noise of the voxels' means [m]
/// @param eye    viewpoint in frame C [m]
/// @param reach  radius of the neighbourhood in voxels
SurfaceSamples make_voxel_samples(const VoxelGrid& grid, const Mask& keep, float sigma,
                                  const Eigen::Vector3f& eye, float reach);

}  // namespace quadrille
