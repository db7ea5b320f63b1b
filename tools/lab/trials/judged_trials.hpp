#pragma once

#include <optional>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "lab/scoring/score.hpp"
#include "quadrille/detector/options.hpp"
#include "surfaces/trial.hpp"

namespace quadrille::trials {

/// A candidate that the detector tried, its outcome, and the judgement by the ground truth.
struct JudgedTrial {
  Candidate candidate;
  SearchLevel level = SearchLevel::kCoarse;
  Trial trial;
  /// Judgement of the candidate's own quadric.
  scoring::Judgement of_candidate;
  /// Judgement of the better fit, if there is one.
  std::optional<scoring::Judgement> of_surface;
};

/// Returns everything that the detector tries on a frame, in the order of the trials. A candidate
/// of a coarse level that is refused is tried again on the next level. A candidate whose samples
/// are all claimed before its turn is not tried, and not included.
std::vector<JudgedTrial> judged_trials(const scoring::Frame& frame, const DetectorOptions& options);

}  // namespace quadrille::trials
