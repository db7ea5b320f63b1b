#pragma once

#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Divides samples into connected pieces, the largest first, and divides these where they are bent
/// inwards: things that touch each other meet in a crease, while most things bulge (Stein et al.,
/// "Object Partitioning using Local Convexity", CVPR 2014). Samples in a crease go to the nearest
/// piece.
/// @param open  the samples to be divided
std::vector<std::vector<int>> convex_pieces(const SurfaceSamples& samples, const Mask& open);

}  // namespace quadrille
