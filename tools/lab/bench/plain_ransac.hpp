#pragma once

#include <cstdint>
#include <vector>

#include "lab/bench/oriented_cloud.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::bench {

using scoring::Found;

/// What a plain RANSAC draws.
enum class PlainBasis {
  kNinePoints,          ///< nine points, no normals
  kFourOrientedPoints,  ///< four points with normals and one common gradient scale
};

/// Plain RANSAC over general quadrics, as the paper compares with: large planes first; then bases
/// from balls around random points, the one with most inliers refitted by least squares and taken
/// out, again and again.
struct PlainOptions {
  PlainBasis basis = PlainBasis::kNinePoints;
  OrientationOptions orientation;
  std::uint64_t seed = 1;
  /// Largest distance of an inlier [m], and least cosine of its normal.
  double epsilon = 0.006, min_cosine = 0.9;
  /// The same for planes, and the least share of all points that is one.
  double plane_epsilon = 0.018, min_plane = 0.05;
  /// Radius of the ball that a basis is drawn from [m]; inliers are counted in twice that.
  double reach = 0.1;
  int trials = 500, rounds = 15, min_points = 60;
  /// Least mean angle of the normals about their mean: less is flat [rad].
  double min_spread = 0.42;
};

/// All that it finds, planes too.
std::vector<Found> plain_ransac(const std::vector<Eigen::Vector3f>& points,
                                const PlainOptions& options);

}  // namespace quadrille::bench
