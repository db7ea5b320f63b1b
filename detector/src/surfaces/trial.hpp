#pragma once

#include <functional>
#include <optional>

#include "search/candidate.hpp"
#include "surfaces/acceptance.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The step at which the aggregation finished with a candidate, in the order of steps.
enum class TrialEnd {
  kClaimed,     ///< better candidates explain most of its samples
  kFirstLook,   ///< its own fit was too poor to try a better one
  kFit,         ///< no better fit was found, or it was thin, noisy or flat
  kConfidence,  ///< the better fit had too little confidence
  kAccepted,
};

/// The outcome of a candidate.
struct Trial {
  TrialEnd end = TrialEnd::kClaimed;
  /// Evidence for the candidate's own fit, if it was collected.
  std::optional<Evidence> first_look;
  /// The better fit, if there is one, with its evidence if that was collected.
  std::optional<Surface> surface;
};

/// Called for each candidate that is tried.
using TrialObserver = std::function<void(const Candidate&, SearchLevel, const Trial&)>;

}  // namespace quadrille
