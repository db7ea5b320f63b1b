#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "planes/planes.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "search/candidate.hpp"
#include "surfaces/acceptance.hpp"
#include "surfaces/claims.hpp"
#include "surfaces/extend.hpp"
#include "surfaces/pending.hpp"
#include "surfaces/trial.hpp"
#include "surfaces/weigh.hpp"

namespace quadrille {

/// Chooses among overlapping candidates (paper, "Hypotheses aggregation"). The candidate that
/// explains most comes first; it is refitted to everything that it explains, connected or not,
/// verified, joined with earlier surfaces that the same quadric explains, and claims its samples.
class Aggregation {
 public:
  /// @param samples  samples to which regions and claims refer; they must outlive this
  /// @param observer  called for each candidate that is tried; may be empty
  /// @param threads   number of threads that try candidates; it never changes the result
  Aggregation(const SurfaceSamples& samples, const AggregateOptions& options,
              const InlierTest& inlier, SceneContext context = {}, TrialObserver observer = {},
              int threads = 1);

  /// Takes candidates, whose regions refer to the samples, and accepts those that qualify.
  /// Candidates refused at a coarse level are kept for the next call.
  /// @param doubts  surfaces that it returns true for are accepted only if, after all others, their
  ///   samples are still open; may be empty
  void offer(std::vector<Candidate> candidates, SearchLevel level,
             const std::function<bool(const Surface&)>& doubts = {});

  /// Takes planes that were found among unclaimed samples, and accepts those that are credible
  /// surfaces of their own.
  void offer_planes(const std::vector<PlaneRegion>& planes);

  /// Per sample, nonzero if no accepted surface has claimed it.
  const Mask& free() const { return accepted_.claims.free(); }
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  /// An accepted surface, as the evidence for others sees it: its quadric, and the middle and size
  /// of its region.
  struct Place {
    Quadric Q;
    Normalisation local;
  };
  /// The surfaces that were accepted so far, as far as the trial of a candidate depends on them.
  struct Accepted {
    Claims claims;
    /// One for each surface.
    std::vector<Place> places;
  };
  class Offer;

  Trial try_out(PendingCandidate* pending, const Acceptance& asked, const Accepted& accepted) const;
  bool is_promising(PendingCandidate* pending, const Acceptance& asked, const Accepted& accepted,
                    Trial* trial) const;
  double first_confidence(PendingCandidate* pending, double asked, const Accepted& accepted) const;
  bool is_acceptable(const Surface& surface, const Acceptance& asked) const;
  std::optional<Surface> plane_instead(Surface surface, const Acceptance& asked) const;
  std::vector<Surface> joined(Surface surface);
  void accept(Surface surface);
  void weigh(Surface* surface, const Accepted& accepted, double asked = 0.0) const;
  double asked_of(const Surface& surface, const Acceptance& asked) const;
  EvidenceSource source(const Accepted& accepted) const {
    return {samples_, blocks_, context_, &accepted.claims};
  }
  const Mask& around(std::span<const int> region, const Accepted& accepted) const;

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  InlierTest inlier_;
  SceneContext context_;
  TrialObserver observer_;
  int threads_;
  SampleBlocks blocks_;
  Extender extender_;
  Accepted accepted_;
  std::vector<PendingCandidate> pending_;
  std::vector<Surface> surfaces_;
};

}  // namespace quadrille
