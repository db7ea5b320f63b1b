#pragma once

#include <optional>
#include <vector>

#include "lab/scoring/frame.hpp"
#include "lab/scoring/score.hpp"
#include "quadrille/detector/options.hpp"
#include "surfaces/trial.hpp"

namespace quadrille::trials {

/// A candidate that the detector tried, what became of it, and what the truth says.
struct JudgedTrial {
  Candidate candidate;
  SearchLevel level = SearchLevel::kCoarse;
  Trial trial;
  /// Of the candidate's own quadric.
  scoring::Judgement of_candidate;
  /// Of the better fit, if there is one.
  std::optional<scoring::Judgement> of_surface;
};

/// All that the detector tries on a frame, in the order of the trials. A candidate of a coarse
/// level that is refused is tried again on the next one. One whose samples are all claimed by the
/// time of its turn is not tried, and not among them.
std::vector<JudgedTrial> judged_trials(const scoring::Frame& frame, const DetectorOptions& options);

}  // namespace quadrille::trials
