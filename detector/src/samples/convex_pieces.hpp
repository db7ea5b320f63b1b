#pragma once

#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// The connected pieces of some samples, the largest first.
std::vector<std::vector<int>> connected_pieces(const SurfaceSamples& samples, Mask open);

/// Divides samples where they are bent inwards: things that touch each other meet in a crease,
/// while most things bulge (Stein et al., "Object Partitioning using Local Convexity", CVPR 2014).
/// The samples in a crease go to the nearest piece.
/// @param connected  the samples to be divided, which are connected
/// @return the pieces, the largest first
std::vector<std::vector<int>> convex_pieces(const SurfaceSamples& samples,
                                            const std::vector<int>& connected);

}  // namespace quadrille
