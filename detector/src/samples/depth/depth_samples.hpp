#pragma once

#include <vector>

#include "base/mask.hpp"
#include "samples/depth/depth_cells.hpp"
#include "samples/depth/noise.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Surface samples of a single view. In a window of (2 reach + 1)² cells around each cell, the
/// inverse depth is fitted by an affine function of the tangents, w = a + b u + c v. This is exact
/// on a plane, whose normal in the view's frame is (b, c, a).
/// @param keep   cells to use, in windows too
/// @param noise  gives each sample's sigma
/// @param X_CV   pose of the view's frame in frame C
/// @param reach  half the window [cells]
SurfaceSamples make_depth_samples(const DepthCells& cells, const Mask& keep,
                                  const NoiseModel& noise, const Eigen::Isometry3f& X_CV,
                                  int reach);

}  // namespace quadrille
