#pragma once

#include <vector>

#include "lab/scoring/frame.hpp"
#include "quadrille/detector/options.hpp"
#include "surfaces/evidence/confidence_model.hpp"

namespace quadrille::confidence_training {

/// A surface that the detector weighed, and whether it exists.
struct Observation {
  /// The evidence; see confidence_terms().
  ConfidenceTerms terms{};
  bool flat = false, right = false;
};

/// Returns the surfaces that the detector weighs in a frame, judged by the rule of
/// scoring::score(): its better fits to candidates, and its planes. A finding of a hardly visible
/// surface is left out, as is a curved finding on a true plane, since both are neither right nor
/// wrong.
std::vector<Observation> observe(const scoring::Frame& frame, DetectorOptions options);

}  // namespace quadrille::confidence_training
