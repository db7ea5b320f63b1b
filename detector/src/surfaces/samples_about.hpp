#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Samples that may lie on one side of a body which is revolved about an axis.
struct SamplesAbout {
  /// Their numbers, in ascending order.
  std::vector<int> samples;
  /// True if they show the outer side, false if the inner one.
  bool outside = true;
};

/// The samples of a region and those connected with it that may lie on the same body, which is
/// revolved about an axis: their normal lines meet it, they show the side that most of the region
/// shows, and they lie beyond the region's ends by no more than half its length.
/// @param X_CA    pose whose z axis is the axis
/// @param region  not empty
/// @param free    the other samples that may be taken; if empty, all
SamplesAbout samples_about(const Eigen::Isometry3d& X_CA, std::span<const int> region,
                           const SurfaceSamples& samples, const Mask& free);

}  // namespace quadrille
