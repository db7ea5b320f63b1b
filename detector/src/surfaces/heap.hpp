#pragma once

#include <Eigen/Core>
#include <vector>

#include "planes/planes.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// True if a curved surface lies like cloth, a bag or grain on one of the level planes: it bulges
/// from the plane, reaches down to it where the plane was seen, is nowhere steeper than 45° against
/// it, and is too uneven for a dome. The sides of solid things that stand or lie are steeper, at
/// least at their foot.
/// @param samples  samples on which the surface was found
/// @param planes, coarse  the planes, and the samples on which they were found
/// @param up  unit normal of the ground; level planes are parallel to it within 20°
bool is_heap(const Surface& surface, const SurfaceSamples& samples,
             const std::vector<PlaneRegion>& planes, const SurfaceSamples& coarse,
             const Eigen::Vector3d& up);

}  // namespace quadrille
