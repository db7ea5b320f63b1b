#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "search/vote_histogram.hpp"

namespace quadrille {

/// Samples of a neighbourhood, which propose a quadric and vote for it.
struct Voters {
  /// Positions in coordinates of the neighbourhood, which has unit size there, and unit normals.
  OrientedPointsf points;
  /// Index of the sample of each point.
  std::vector<int> samples;
  /// Largest distance of a voter from a quadric that it supports, in the unit of the points.
  float max_distance = 0.0f;
  VoteOptions vote;
};

/// A quadric that a neighbourhood may lie on.
struct Hypothesis {
  /// Symmetric matrix in the coordinates of the voters, with its gradient on the side of the
  /// normals.
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  /// Number of voters that support it.
  int support = 0;
};

/// A way to propose the quadric of a neighbourhood. Without any it returns one of zero support.
using Propose = std::function<Hypothesis(const Voters&, RandomStream&)>;

/// Draws one of the points.
OrientedPoint draw_point(const OrientedPointsf& points, RandomStream& random);

/// Draws a random basis and returns the quadrics through it as symmetric 4x4 matrices in the
/// coordinates of the points, with gradients on the side of the normals; none if the basis is
/// degenerate.
/// @param points  normalised oriented points of a neighbourhood, at least one, which also vote
std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const OrientedPointsf& points,
                                             const VoteOptions& options, RandomStream& random);

/// Counts the points that lie within a first-order distance of a quadric and whose normal agrees
/// with its gradient.
/// @param Q           symmetric 4x4 matrix in the coordinates of the points, its gradient on the
///   side of the normals
/// @param distance    largest distance in the unit of the points
/// @param min_cosine  least cosine between normal and gradient
int count_support(const OrientedPointsf& points, const Eigen::Matrix4d& Q, float distance,
                  float min_cosine);

/// The quadric with the number of voters that support it.
Hypothesis supported(const Voters& voters, const Eigen::Matrix4d& Q);

/// Draws a number of bases, and returns the first hypothesis with the most support (RANSAC).
Hypothesis propose(const Voters& voters, BasisKind kind, int bases, RandomStream& random);

}  // namespace quadrille
