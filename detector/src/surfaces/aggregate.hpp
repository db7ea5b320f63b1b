#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "planes/planes.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "search/candidate.hpp"
#include "surfaces/candidate_judge.hpp"
#include "surfaces/pending.hpp"
#include "surfaces/trial.hpp"

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

  /// Divides accepted surfaces that are a cylinder and a cone; see two_pieces(). Without a cylinder
  /// beside them that shows the axis, the evidence must be very strong, or the new cylinder
  /// credible alone.
  void divide();

  /// Takes planes that were found among unclaimed samples, and accepts those that are credible
  /// surfaces of their own.
  void offer_planes(const std::vector<PlaneRegion>& planes);

  /// Per sample, nonzero if no accepted surface has claimed it.
  const Mask& free() const { return accepted_.claims.free(); }
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  class Offer;

  std::vector<Surface> joined(Surface surface);
  void remove(std::size_t surface);
  void accept(Surface surface);

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  InlierTest inlier_;
  TrialObserver observer_;
  int threads_;
  CandidateJudge judge_;
  AcceptedSurfaces accepted_;
  std::vector<PendingCandidate> pending_;
  std::vector<Surface> surfaces_;
};

}  // namespace quadrille
