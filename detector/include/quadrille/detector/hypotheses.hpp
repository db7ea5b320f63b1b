#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/geometric_fit.hpp"
#include "quadrille/detector/random.hpp"
#include "quadrille/detector/vote.hpp"

namespace quadrille {

/// How hypotheses are drawn from a neighbourhood.
enum class BasisKind {
  kThreePoints,  ///< three oriented points and a vote along their null space (paper, section 4)
  kFourPoints,   ///< a fourth point fixes λ (paper, theorem 3)
  kNinePoints,   ///< nine points without normals
  kSphere,       ///< one oriented point and a vote for the radius (paper, figure 2b)
};

/// Quadrics through one random basis, as symmetric 4x4 matrices in the coordinates of the voters,
/// gradients on the side of the normals; none if the basis is degenerate.
/// @param voters  oriented points of a neighbourhood, normalised; at least one
std::vector<Eigen::Matrix4d> draw_hypotheses(BasisKind kind, const FitPoints& voters,
                                             const VoteOptions& options, RandomStream& random);

}  // namespace quadrille
