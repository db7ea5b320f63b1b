#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "search/triplet_set.hpp"
#include "search/vote.hpp"

namespace quadrille {

/// Remembers the bases of three points that were voted on, so that none is voted on twice.
struct BasisMemory {
  TripletSet triplets;
  /// For each voter, the index of its sample.
  std::vector<int> sample_of_voter;
};

/// Draws a random basis and returns the quadrics through it as symmetric 4x4 matrices in the
/// coordinates of the voters, with gradients on the side of the normals; none if the basis is
/// degenerate.
/// @param voters  normalised oriented points of a neighbourhood, at least one
/// @param memory  refuses a basis of three points that it knows and records others; may be null,
///   and is not used for other kinds of bases
std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const OrientedPointsf& voters,
                                             const VoteOptions& options, RandomStream& random,
                                             BasisMemory* memory = nullptr);

/// Counts the voters that lie within a first-order distance of a quadric and whose normal agrees
/// with its gradient.
/// @param Q           symmetric 4x4 matrix in the coordinates of the voters, its gradient on the
///   side of the normals
/// @param distance    largest distance in the unit of the voters
/// @param min_cosine  least cosine between normal and gradient
int count_support(const OrientedPointsf& voters, const Eigen::Matrix4d& Q, float distance,
                  float min_cosine);

}  // namespace quadrille
