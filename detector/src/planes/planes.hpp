#pragma once

#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// One plane n·x + d = 0, n towards the viewpoint.
struct PlaneRegion {
  Eigen::Vector4d plane;
  std::vector<int> samples;
};

/// Grows planes over neighbours from the flattest seeds (type-specific fit: one oriented point
/// determines a plane, paper, table of minimal cases).
/// @param claimed  per sample, nonzero to leave it out; empty for none
std::vector<PlaneRegion> find_planes(const SurfaceSamples& samples, const PlaneOptions& options,
                                     const std::vector<char>& claimed = {});

}  // namespace quadrille
