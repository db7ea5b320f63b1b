#pragma once

#include <vector>

#include "search/vote.hpp"

namespace quadrille {

/// Votes for one parameter in (−∞, ∞), binned by its place (see quantisation.hpp).
class VoteHistogram {
 public:
  explicit VoteHistogram(const VoteOptions& options);

  void add(float lambda);
  /// The highest local maxima after smoothing with a triangular kernel of two bins (kernel density
  /// estimation), highest first. The range is no circle: its ends are approached from two sides.
  std::vector<VotePeak> peaks() const;

 private:
  VoteOptions options_;
  std::vector<float> count_;
};

}  // namespace quadrille
