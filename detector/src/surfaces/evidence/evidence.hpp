#pragma once

#include <span>

#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Real objects are quadrics up to this share of their size: cups and posts are, as scans show.
inline constexpr double kFlawShare = 0.02;

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
  /// Share of the samples all of whose neighbours lie within the region.
  double interior = 0.0;
  /// Standard deviation of the positions across the region over that along it.
  double thickness = 0.0;
  /// Root mean square distance from the middle, and edge of a cell [m].
  double size = 0.0, cell = 0.0;
  /// log(rss of the best two planes / rss of the quadric): a box edge really is a rank-2 quadric,
  /// and a curved one explains it no better than two planes do.
  double two_planes = 0.0;
  /// The same with the best single plane: how far beyond its own residual the region bends.
  double one_plane = 0.0;
  /// Noise that is measured for the samples [m], and the part of it that neighbours have in common;
  /// see SurfaceSamples.
  double sigma = 0.0, common_noise = 0.0;
  /// Root mean square distance from the quadric, and of the differences between neighbours over √2,
  /// both in multiples of sigma.
  double residual = 1.0, roughness = 1.0;
  /// Correlation of the distances of neighbours, −1 to 1.
  double correlation = 0.0;
  /// Sum of the principal curvatures times the size, positive where the quadric bulges towards the
  /// sensor: mean over the samples.
  double convexity = 0.0;
  /// Samples within the box of the region that lie off the quadric, towards the sensor and behind
  /// it, per sample of the region: through a real surface nothing is seen. See intruders.hpp.
  double in_front = 0.0, behind = 0.0;
  /// Open samples of the smooth parts that the region lies in and that it leaves over, per sample
  /// of the region: an object is explained as a whole. See claims.hpp.
  double remainder = 0.0;
  /// |cosine| between axis and up; see upright.hpp.
  double uprightness = 1.0;
  /// Share of what has to be seen that is not there; see see_through.hpp.
  double see_through = 0.0;
};

/// Angle between the samples' normals and their mean, 90th percentile [rad]: the spread of the
/// evidence, of a region that is not empty.
double normal_spread(const SurfaceSamples& samples, std::span<const int> region);

/// Collects the evidence for a quadric whose inliers are the region, all but what lies about it:
/// intruders, remainder, uprightness and what is seen through it.
/// @param region  not empty
/// @param beyond  per sample, nonzero where another surface begins; may be empty
Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& Q, std::span<const char> beyond = {});

}  // namespace quadrille
