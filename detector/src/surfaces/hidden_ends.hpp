#pragma once

#include <Eigen/Geometry>
#include <span>

#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// True if a surface that continues straight along z of frame Q may reach unseen beyond an end of
/// its samples: in every view, most of that continuation would be hidden behind something else or
/// outside the image. False if it stands on what is seen there, if something is seen behind it, or
/// if a view has no cells.
/// @param extent_Q  extent of the region's samples [m]
bool hides_an_end(std::span<const Sight> sights, const SurfaceSamples& samples,
                  std::span<const int> region, const Eigen::Isometry3d& X_CQ,
                  const Eigen::AlignedBox3d& extent_Q);

}  // namespace quadrille
