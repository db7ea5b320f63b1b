#pragma once

#include <span>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Residual sum of squares of the best two planes through a region [m²]. The samples are divided by
/// 2-means over their normals, then by the nearer plane in a few rounds of Lloyd's algorithm.
/// @param region  not empty; of a large region only some hundred samples are used
double two_planes_rss(const SurfaceSamples& samples, std::span<const int> region);

}  // namespace quadrille
