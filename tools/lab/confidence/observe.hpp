#pragma once

#include <array>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "quadrille/detector/options.hpp"
#include "surfaces/evidence/confidence_model.hpp"

namespace quadrille::confidence_training {

/// A surface that the detector considered, and whether it is there.
struct Observation {
  /// See confidence_terms().
  std::array<double, kConfidenceTerms.size()> terms{};
  bool flat = false, right = false;
};

/// What the detector weighs in a frame, judged by the rule of scoring::score(): its better fits to
/// candidates, and its planes. What finds a surface that is hardly visible is left out, as is a
/// curved one that is a true plane: it is neither right nor wrong.
std::vector<Observation> observe(const scoring::Frame& frame, DetectorOptions options);

}  // namespace quadrille::confidence_training
