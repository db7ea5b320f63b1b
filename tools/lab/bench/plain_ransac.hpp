#pragma once

#include <cstdint>
#include <vector>

#include "lab/bench/oriented_cloud.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::bench {

using scoring::Found;

/// The basis that a plain RANSAC draws.
enum class PlainBasis {
  kNinePoints,          ///< nine points, no normals
  kFourOrientedPoints,  ///< four points with normals and one common gradient scale
};

/// Plain RANSAC over general quadrics, the baseline of the paper. Large planes are removed first.
/// Then bases are drawn from balls around random points, and the quadric with the most inliers is
/// refitted by least squares and removed, repeatedly.
struct PlainOptions {
  PlainBasis basis = PlainBasis::kNinePoints;
  OrientationOptions orientation;
  std::uint64_t seed = 1;
  /// Largest distance of an inlier [m], and least cosine between its normal and the gradient.
  double epsilon = 0.006, min_cosine = 0.9;
  /// Largest distance of an inlier of a plane [m], and the least share of all points on a plane.
  double plane_epsilon = 0.018, min_plane = 0.05;
  /// Radius of the ball from which a basis is drawn [m]; inliers are counted within twice that
  /// radius.
  double reach = 0.1;
  int trials = 500, rounds = 15, min_points = 60;
  /// Least mean angle of the normals about their mean [rad]; patches with less count as flat.
  double min_spread = 0.42;
};

/// Returns everything that it finds, including planes.
std::vector<Found> plain_ransac(const std::vector<Eigen::Vector3f>& points,
                                const PlainOptions& options);

}  // namespace quadrille::bench
