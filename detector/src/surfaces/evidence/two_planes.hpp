#pragma once

#include <span>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Residual sum of squares of the best two planes through a region [m²]: the samples are parted
/// by 2-means over their normals, then by the nearer plane, in a few rounds of Lloyd's algorithm.
/// @param region  not empty; of many samples some hundred stand for all
double two_planes_rss(const SurfaceSamples& samples, std::span<const int> region);

}  // namespace quadrille
