#pragma once

#include <span>
#include <vector>

#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Centre and mean square radius of the raw positions of a region.
Normalisation normalisation_of(const SurfaceSamples& samples, std::span<const int> region);

/// The region if it has no more samples than max_count, else that many, spread evenly; some of them
/// twice where it has hardly more.
std::vector<int> spread_evenly(std::span<const int> region, std::size_t max_count);

/// Up to max_count points of a region, spread evenly, raw positions in local coordinates.
OrientedPointsf fit_points(const SurfaceSamples& samples, std::span<const int> region,
                           const Normalisation& normalisation, int max_count);

}  // namespace quadrille
