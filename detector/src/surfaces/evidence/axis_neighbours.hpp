#pragma once

#include <Eigen/Geometry>
#include <span>

#include "samples/surface_samples.hpp"
#include "search/axes/axis_votes.hpp"
#include "surfaces/evidence/sample_blocks.hpp"

namespace quadrille {

/// Counts of samples around a region, per sample of the region.
struct AxisNeighbours {
  /// Samples whose normal line meets the axis, as those of the other pieces of the same body do,
  /// and samples whose normal line misses it.
  double meet = 0.0, miss = 0.0;
};

/// Looks about the axis of a region for other pieces of a body that is revolved about it: within
/// one and a half times the region's largest radius, and beyond its ends by as much. Samples whose
/// normals are nearly parallel to the axis belong to lids and supports, and are not counted.
/// @param region  not empty
AxisNeighbours axis_neighbours(const SurfaceSamples& samples, const SampleBlocks& blocks,
                               std::span<const int> region, const Axis& axis);

}  // namespace quadrille
