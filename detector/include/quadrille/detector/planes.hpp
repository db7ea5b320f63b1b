#pragma once

#include <vector>

#include "quadrille/detector/quadric.hpp"
#include "quadrille/detector/surface_samples.hpp"

namespace quadrille {

struct PlaneOptions {
  /// Samples that a plane has at least.
  int least_samples = 40;
  /// Largest distance, in multiples of the samples' sigma.
  double sigmas = 3.0;
  /// Largest angle between the normals of sample and plane [rad].
  double angle = 0.26;
  /// A region whose quadratic fit bends with a smaller radius [m], significantly, is no plane.
  double least_radius = 0.7;
  /// Nor is one that might bend with a smaller radius than this [m], for all that its noise lets
  /// one say.
  double least_proven_radius = 0.3;
};

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
