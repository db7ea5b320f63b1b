#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "fit/oriented_points.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "search/triplet_set.hpp"
#include "search/vote.hpp"

namespace quadrille {

/// The bases of three points that were voted on, so that none is twice.
struct BasisMemory {
  TripletSet triplets;
  /// The sample that each voter is.
  std::vector<int> sample_of_voter;
};

/// Quadrics through one random basis, as symmetric 4x4 matrices in the coordinates of the voters,
/// gradients on the side of the normals; none if the basis is degenerate.
/// @param voters  oriented points of a neighbourhood, normalised; at least one
/// @param memory  refuses a basis of three points that it knows, and learns the others; null for
///                none. The other kinds of bases do without.
std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const OrientedPointsf& voters,
                                             const VoteOptions& options, RandomStream& random,
                                             BasisMemory* memory = nullptr);

/// How many of the voters lie within a distance of a quadric, first order, with the normal of its
/// gradient.
/// @param Q             symmetric 4x4 matrix in the coordinates of the voters, its gradient on the
///                      side of the normals
/// @param distance      in the unit of the voters
/// @param min_cosine  between normal and gradient
int count_support(const OrientedPointsf& voters, const Eigen::Matrix4d& Q, float distance,
                  float min_cosine);

}  // namespace quadrille
