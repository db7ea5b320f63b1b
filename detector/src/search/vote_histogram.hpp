#pragma once

#include <vector>

#include "search/vote.hpp"

namespace quadrille {

/// Histogram of the votes for one parameter in (−∞, ∞), mapped to bins by place_of() (see
/// quantisation.hpp).
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
  std::vector<float> count_;
};

}  // namespace quadrille
