#pragma once

#include <functional>
#include <optional>

#include "search/candidate.hpp"
#include "surfaces/acceptance.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// Where the aggregation was done with a candidate, in the order of its steps.
enum class TrialEnd {
  kClaimed,     ///< better ones explain most of its samples
  kFirstLook,   ///< its own fit is not worth a better one
  kFit,         ///< no better fit, or one that is thin, noisy or flat
  kConfidence,  ///< too little confidence in the better fit
  kAccepted,
};

/// What became of a candidate.
struct Trial {
  TrialEnd end = TrialEnd::kClaimed;
  /// Evidence for the candidate's own fit, if it was looked at.
  std::optional<Evidence> first_look;
  /// The better fit, if there is one, with its evidence if that was asked for.
  std::optional<Surface> surface;
};

/// Called for each candidate that is tried.
using TrialObserver = std::function<void(const Candidate&, SearchLevel, const Trial&)>;

}  // namespace quadrille
