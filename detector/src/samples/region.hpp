#pragma once

#include <span>
#include <vector>

#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Centre and root mean square radius of the raw positions of a region.
Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region);

/// Returns the region if it has at most max_count samples, otherwise max_count of its samples
/// spread evenly; samples may repeat if the region is hardly larger.
std::vector<int> spread_evenly(std::span<const int> region, std::size_t max_count);

/// Returns up to max_count points of a region, spread evenly, with raw positions in local
/// coordinates.
OrientedPointsf fit_points(const SurfaceSamples& samples, std::span<const int> region,
                           const Normalisation& normalisation, int max_count);

}  // namespace quadrille
