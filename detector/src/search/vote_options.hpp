#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Options for casting and counting votes.
struct VoteOptions {
  GradientLengths lengths = GradientLengths::kCommon;
  Quantisation quantisation = Quantisation::kArctangent;
  /// Number of bins over the mapped range of λ.
  int bins = 48;
  /// λ₀: the curvature [1/unit] that maps to the middle of a half axis.
  double lambda_scale = 1.0;
  /// Least distance of a voter from the data plane, in the unit of the points; nearer voters hardly
  /// depend on λ.
  double min_height = 0.05;
  /// Least cosine between the voter's normal and the gradient of the quadric that it votes for.
  double min_cosine = 0.85;
  /// Largest number of peaks to return.
  int peaks = 2;
};

}  // namespace quadrille
