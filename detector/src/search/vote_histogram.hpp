#pragma once

#include <vector>

namespace quadrille {

/// A map of a vote's parameter λ in (−∞, ∞) to a place between 0 and 1, the range that is divided
/// into bins (paper, "Quantizing λ"), and its inverse for places strictly between 0 and 1.
struct Quantisation {
  float (*place_of)(float lambda);
  float (*lambda_at)(float place);
};

/// 1/2 + atan(λ) / π, the angle named in the paper's footnote.
extern const Quantisation kArctangent;

/// Options for casting and counting votes.
struct VoteOptions {
  Quantisation quantisation = kArctangent;
  int bins = 48;
  /// Least distance of a voter from the data plane, in the unit of the points; nearer voters hardly
  /// depend on λ.
  double min_height = 0.05;
  /// Least cosine between the voter's normal and the gradient of the quadric that it votes for.
  double min_cosine = 0.85;
  /// Largest number of peaks to return.
  int peaks = 2;
};

/// One local maximum of the votes.
struct VotePeak {
  double lambda = 0.0;
  double votes = 0.0;
};

/// Histogram of the votes for one parameter in (−∞, ∞).
class VoteHistogram {
 public:
  explicit VoteHistogram(const VoteOptions& options);

  void add(float lambda);
  /// Returns the highest local maxima after smoothing with a triangular kernel of two bins (kernel
  /// density estimation), highest first. The range is not circular: its two ends are different
  /// values.
  std::vector<VotePeak> peaks() const;

 private:
  VoteOptions options_;
  /// Votes of the bins, with a few empty ones at either end.
  std::vector<float> count_;
  bool is_empty_ = true;
};

}  // namespace quadrille
