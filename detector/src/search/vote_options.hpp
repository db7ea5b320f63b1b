#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// How votes are cast and counted.
struct VoteOptions {
  GradientLengths lengths = GradientLengths::kCommon;
  Quantisation quantisation = Quantisation::kArctangent;
  /// Bins over the places of λ.
  int bins = 48;
  /// λ₀: the curvature [1/unit] that falls into the middle of a half axis.
  double lambda_scale = 1.0;
  /// A voter must be at least this far from the data plane, in units of the points: nearer ones
  /// know nothing of λ.
  double min_height = 0.05;
  /// Least cosine between the voter's normal and the gradient of the quadric that it votes for.
  double min_cosine = 0.85;
  /// Peaks to return at most.
  int peaks = 2;
};

}  // namespace quadrille
