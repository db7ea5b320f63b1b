#pragma once

#include <array>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "surfaces/evidence/confidence_weights.hpp"

namespace quadrille::confidence_training {

/// A curved surface that the detector considered, and whether it is there.
struct Observation {
  /// See confidence_terms() and log_prior().
  std::array<double, kConfidenceWeights.size()> terms{};
  double log_prior = 0.0;
  bool right = false;
};

/// The candidates that the search finds on all levels of a frame, each weighed as if nothing else
/// had been found, and judged by the rule of scoring::score(). What finds a surface that is hardly
/// visible, or a true plane, is left out: it is neither right nor wrong.
std::vector<Observation> observe(const scoring::Frame& frame);

}  // namespace quadrille::confidence_training
