#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "surfaces/acceptance.hpp"
#include "surfaces/claims.hpp"
#include "surfaces/extend.hpp"
#include "surfaces/pending.hpp"
#include "surfaces/trial.hpp"
#include "surfaces/weigh.hpp"

namespace quadrille {

/// The surfaces that were accepted so far, as far as the trial of a candidate depends on them.
struct AcceptedSurfaces {
  /// An accepted surface, as the evidence for others sees it: its quadric, and the middle and size
  /// of its region.
  struct Place {
    Quadric Q;
    Normalisation local;
  };

  Claims claims;
  /// One for each surface.
  std::vector<Place> places;
};

/// Tries candidates: refits each to all samples that it explains, and judges the fit by its
/// evidence.
class CandidateJudge {
 public:
  /// @param samples  samples to which regions and claims refer; they must outlive this
  /// @param needs_all_evidence  true to collect all evidence for each candidate; otherwise what
  ///   cannot change the judgement is left out, since it takes long
  CandidateJudge(const SurfaceSamples& samples, const AggregateOptions& options,
                 const InlierTest& inlier, SceneContext context, bool needs_all_evidence);

  /// Tries a candidate, and remembers in it what the next trial may need again.
  Trial try_out(PendingCandidate* pending, const Acceptance& asked,
                const AcceptedSurfaces& accepted) const;

  /// Sets a surface's evidence and confidence.
  /// @param asked  see quadrille::weigh()
  void weigh(Surface* surface, const AcceptedSurfaces& accepted, double asked = 0.0) const;

 private:
  bool is_promising(PendingCandidate* pending, const Acceptance& asked,
                    const AcceptedSurfaces& accepted, Trial* trial) const;
  double first_confidence(PendingCandidate* pending, double asked,
                          const AcceptedSurfaces& accepted) const;
  bool is_acceptable(const Surface& surface, const Acceptance& asked) const;
  std::optional<Surface> plane_instead(Surface surface, const Acceptance& asked) const;
  double asked_of(const Surface& surface, const Acceptance& asked) const;
  EvidenceSource source(const AcceptedSurfaces& accepted) const {
    return {samples_, blocks_, context_, &accepted.claims};
  }
  const Mask& around(std::span<const int> region, const AcceptedSurfaces& accepted) const;

  const SurfaceSamples& samples_;
  AggregateOptions options_;
  SceneContext context_;
  bool needs_all_evidence_;
  SampleBlocks blocks_;
  Extender extender_;
};

}  // namespace quadrille
