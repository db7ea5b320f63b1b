#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "search/candidate.hpp"
#include "surfaces/surface.hpp"
#include "surfaces/weigh.hpp"

namespace quadrille {

/// A candidate that waits to be tried, perhaps again, and what earlier trials found out about it.
struct PendingCandidate {
  Candidate candidate;
  explicit PendingCandidate(Candidate from) : candidate(std::move(from)) {}

  /// The candidate's open samples when it was last tried.
  std::vector<int> open;
  /// The spread of their normals, and the evidence for the candidate's own fit to them.
  std::optional<double> spread;
  std::optional<LastingEvidence> evidence;
  /// True if the evidence includes what is seen through the quadric.
  bool looked_through = false;
  /// The better fit to them, which may not exist.
  std::optional<std::optional<Surface>> fit;

  /// Sets the open samples and forgets what was found out about others. Claims only grow, so as
  /// many samples are the same samples.
  void set_open(std::vector<int> now) {
    if (now.size() == open.size()) return;
    open = std::move(now);
    spread.reset();
    evidence.reset();
    looked_through = false;
    fit.reset();
  }
};

}  // namespace quadrille
