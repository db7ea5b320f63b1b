#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/basis.hpp"
#include "quadrille/detector/geometric_fit.hpp"
#include "quadrille/detector/quantisation.hpp"

namespace quadrille {

/// How votes are cast and counted.
struct VoteOptions {
  Quantisation quantisation = Quantisation::kArctangent;
  /// Bins over the places of λ.
  int bins = 48;
  /// λ₀: the curvature [1/unit] that falls into the middle of a half axis.
  double lambda_scale = 1.0;
  /// A voter must be at least this far from the data plane, in units of the points: nearer ones
  /// know nothing of λ.
  double least_height = 0.05;
  /// Least cosine between the voter's normal and the gradient of the quadric that it votes for.
  double least_cosine = 0.85;
  /// Peaks to return at most.
  int peaks = 2;
};

/// One local maximum of the votes.
struct VotePeak {
  double lambda = 0.0;
  double votes = 0.0;
};

/// Local voting along the null space (paper, theorem 3 and "Quantizing λ"): each point x votes for
/// λ = −f₀(x) / z(x)², if there the gradient agrees with its normal; the histogram is
/// smoothed (KDE) and its highest peaks are returned, highest first.
std::vector<VotePeak> vote(const Pencil& pencil, const FitPoints& voters,
                           const VoteOptions& options);

}  // namespace quadrille
