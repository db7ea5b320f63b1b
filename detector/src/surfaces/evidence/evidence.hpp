#pragma once

#include <span>
#include <vector>

#include "base/mask.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Real objects deviate from quadrics by up to this share of their size, as scans of cups and posts
/// show.
inline constexpr double kFlawShare = 0.02;

/// The evidence for and against a fitted quadric.
struct Evidence {
  /// Natural logarithm of the number of samples.
  double log_count = 0.0;
  /// Angle between the samples' normals and their mean, 90th percentile [rad].
  double spread = 0.0;
  /// Share of the region's border, 0 to 1, where the surface continues smoothly into samples that
  /// are no inliers. The border of a patch cut out of something else does so; an object's border
  /// does not, unless another object begins there.
  double smooth_border = 0.0;
  /// Share of the samples with a neighbour outside the region, and share at a depth edge, with
  /// fewer than eight neighbours. A scrap consists mostly of border.
  double open_border = 0.0, depth_edge = 0.0;
  /// Share of the samples whose eight neighbours all lie within the region.
  double interior = 0.0;
  /// Standard deviation of the positions across the region, divided by that along it.
  double thickness = 0.0;
  /// Root mean square distance from the middle, and mean edge of a cell [m].
  double size = 0.0, cell = 0.0;
  /// log(rss of the best two planes / rss of the quadric). The edge of a box is itself a rank-2
  /// quadric, which a curved quadric explains no better than two planes do.
  double two_planes = 0.0;
  /// log(rss of the best plane / rss of the quadric): how far the region bends beyond its own
  /// residual.
  double one_plane = 0.0;
  /// Noise measured for the samples [m], and the share of it that neighbours have in common; see
  /// SurfaceSamples.
  double sigma = 0.0, common_noise = 0.0;
  /// Root mean square distance from the quadric, and root mean square difference between neighbours
  /// divided by √2, both in multiples of sigma.
  double residual = 1.0, roughness = 1.0;
  /// Correlation of neighbouring distances, −1 to 1.
  double correlation = 0.0;
  /// Sum of the principal curvatures times the size, averaged over the samples; positive if the
  /// quadric bulges towards the sensor.
  double convexity = 0.0;
  /// Number of samples within the box of the region that lie off the quadric, towards the sensor
  /// and behind it, per sample of the region. Nothing is seen through a real surface. See
  /// intruders.hpp.
  double in_front = 0.0, behind = 0.0;
  /// Number of open samples that the region leaves over in the smooth parts in which it lies, per
  /// sample of the region. A true surface explains an object as a whole. See claims.hpp.
  double remainder = 0.0;
  /// |cosine| between axis and up direction; see upright.hpp.
  double uprightness = 1.0;
  /// Share of the rays that should meet the quadric but see something behind it; see
  /// see_through.hpp.
  double see_through = 0.0;
  /// Number of samples about the axis whose normal lines meet it, and of those whose lines miss it,
  /// per sample of the region; see axis_neighbours.hpp.
  double meet_axis = 0.0, miss_axis = 0.0;
};

/// Angle between the samples' normals and their mean, 90th percentile [rad], as in
/// Evidence::spread. The region must not be empty.
double normal_spread(const SurfaceSamples& samples, std::span<const int> region);

/// The border of a region, across which its surface may continue smoothly.
struct RegionBorder {
  /// Number of places around the samples that no sample of the region takes; a place counts for
  /// each sample next to it.
  double places = 0.0;
  /// Samples beyond the border into which the surface continues smoothly, one for each such place.
  std::vector<int> beyond;

  /// Evidence::smooth_border, given the samples that belong to no other surface.
  double smooth_share(const Mask& free) const;
};

/// Collects the evidence for a quadric whose inliers are the region, except for that from its
/// surroundings: smooth border, intruders, remainder, uprightness and what is seen through it.
/// @param region  not empty
/// @param border  receives the region's border; its evidence depends on other surfaces
Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& Q, RegionBorder* border);

/// Collects the same evidence and that of the smooth border.
/// @param region  not empty
/// @param free    samples that belong to no other surface
Evidence collect_evidence(const SurfaceSamples& samples, std::span<const int> region,
                          const Quadric& Q, const Mask& free = {});

}  // namespace quadrille
