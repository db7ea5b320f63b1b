#pragma once

#include <span>
#include <vector>

#include "fit/geometric_fit.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// What speaks for and against a fitted quadric.
struct Evidence {
  /// Natural logarithm of the number of samples.
  double log_count = 0.0;
  /// Angle between the samples' normals and their mean, 90th percentile [rad].
  double spread = 0.0;
  /// Share of the region's border where the surface goes on smoothly into samples that are no
  /// inliers, 0 to 1: a patch cut out of something else has such a border, an object has none,
  /// unless another one begins there.
  double smooth_border = 0.0;
  /// Share of the samples that have a neighbour outside the region, and of those at a depth edge,
  /// with fewer than eight neighbours: a scrap is all border.
  double open_border = 0.0, depth_edge = 0.0;
  /// Standard deviation of the positions across the region over that along it.
  double thickness = 0.0;
  /// log(rss of the best two planes / rss of the quadric): a box edge really is a rank-2 quadric,
  /// and a curved one explains it no better than two planes do.
  double two_planes = 0.0;
  /// Root mean square of the residuals' means over neighbours, in multiples of what noise and the
  /// small flaws of real objects leave: something that is no quadric deviates in patches.
  double misfit = 1.0;
  /// Open samples of the smooth parts that the region lies in and that it leaves over, per sample
  /// of the region: an object is explained as a whole. See claims.hpp.
  double remainder = 0.0;
};

/// Collects the evidence for a quadric whose inliers are the region, all but the remainder.
/// @param region  not empty
/// @param beyond  per sample, nonzero where another surface begins; may be empty
Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& Q, std::span<const char> beyond = {});

}  // namespace quadrille
