#pragma once

#include <Eigen/Geometry>
#include <span>

#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// True if a surface that goes straight on along z of frame Q may reach beyond one end of its
/// samples unseen: most of what would be seen of it there lies behind something else, or outside
/// the image. Not so where it stands on what is seen there, or where something is seen behind.
/// False without cells in the sight.
/// @param extent_Q  of the region's samples [m]
bool hides_an_end(const Sight& sight, const SurfaceSamples& samples, std::span<const int> region,
                  const Eigen::Isometry3d& X_CQ, const Eigen::AlignedBox3d& extent_Q);

}  // namespace quadrille
