#include "surfaces/candidate_judge.hpp"

#include <algorithm>
#include <utility>

#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/inliers.hpp"
#include "surfaces/evidence/see_through.hpp"
#include "surfaces/join.hpp"
#include "surfaces/plane_surface.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille {
namespace {

// A candidate's spread of normals may be lower than a surface's by this factor, since the better
// fit covers more of the object.
constexpr double kCandidateSpreadShare = 0.8;
// A region is a separate surface only if its rms distance from every surface around it exceeds this
// share of their size. Flaws of real cups and posts reach 0.05, and a dome lies 0.12 off its post.
constexpr double kMinOffset = 0.08;
// Number of samples of a region that suffice to measure this distance.
constexpr std::size_t kOffsetSamples = 100;

}  // namespace

CandidateJudge::CandidateJudge(const SurfaceSamples& samples, const AggregateOptions& options,
                               const InlierTest& inlier, SceneContext context,
                               bool needs_all_evidence)
    : samples_(samples),
      options_(options),
      context_(std::move(context)),
      needs_all_evidence_(needs_all_evidence),
      blocks_(samples),
      extender_(samples, blocks_, options, inlier) {}

/// Refits the candidate's open samples, extends the fit, and weighs its evidence.
Trial CandidateJudge::try_out(PendingCandidate* pending, const Acceptance& asked,
                              const AcceptedSurfaces& accepted) const {
  Trial trial;
  if (!is_promising(pending, asked, accepted, &trial)) return trial;
  trial.end = TrialEnd::kFit;
  std::optional<Surface>& surface = trial.surface;
  if (!pending->fit) pending->fit = fit_surface(samples_, pending->open, options_);
  surface = *pending->fit;
  // The general family fits a plane by a doubled plane.
  if (surface && is_thin(*surface, samples_)) surface = plane_instead(std::move(*surface), asked);
  if (!surface ||
      surface->rms > asked.max_candidate_residual * mean_sigma(samples_, surface->region)) {
    return trial;
  }
  surface = extender_.extended(std::move(*surface), accepted.claims.free());
  // The extended fit may differ, so it is checked again.
  if (is_thin(*surface, samples_)) return trial;
  weigh(&*surface, accepted, asked_of(*surface, asked));
  // A surface that hardly bends is reported as the plane that it nearly is.
  if (!is_flat(*surface) && surface->evidence.spread < options_.min_spread) {
    surface = plane_instead(std::move(*surface), asked);
    if (!surface) return trial;
    weigh(&*surface, accepted, asked_of(*surface, asked));
  }
  trial.end = is_acceptable(*surface, asked) ? TrialEnd::kAccepted : TrialEnd::kConfidence;
  return trial;
}

/// True if enough of a candidate's samples are open, and its own fit is good enough to try a better
/// one.
bool CandidateJudge::is_promising(PendingCandidate* pending, const Acceptance& asked,
                                  const AcceptedSurfaces& accepted, Trial* trial) const {
  const Candidate& candidate = pending->candidate;
  pending->set_open(accepted.claims.open_of(candidate.region));
  const std::vector<int>& open = pending->open;
  const double min_open = options_.min_open * static_cast<double>(candidate.region.size());
  if (static_cast<int>(open.size()) < options_.min_samples ||
      static_cast<double>(open.size()) < min_open) {
    return false;
  }
  trial->end = TrialEnd::kFirstLook;
  if (candidate.family == Family::kPlane) return true;
  const double min_spread = kCandidateSpreadShare * options_.min_spread;
  if (!pending->spread) pending->spread = normal_spread(samples_, open);
  if (*pending->spread < min_spread) return asked.takes_planes_instead;
  const double confidence = first_confidence(pending, asked.min_candidate_confidence, accepted);
  trial->first_look = pending->evidence->evidence;
  return confidence >= asked.min_candidate_confidence;
}

/// The confidence in a candidate's own fit, or an upper bound if that is less than what is asked.
/// Counting the points that were seen through the quadric takes longer than all other evidence. It
/// is left out if the candidate is refused for any result of it, as most are.
double CandidateJudge::first_confidence(PendingCandidate* pending, double asked,
                                        const AcceptedSurfaces& accepted) const {
  const auto& [Q, family, region, rms] = pending->candidate;
  const std::vector<int>& open = pending->open;
  const CanonicalForm form = canonical_form(Q);
  if (!pending->evidence) pending->evidence = lasting_evidence(source(accepted), open, Q, form);
  look_around(source(accepted), open, around(open, accepted), &*pending->evidence);
  Evidence& evidence = pending->evidence->evidence;
  const auto terms = [&, dof = family_spec(family).dof] {
    return confidence_terms(evidence, dof, log_prior(form.type));
  };
  if (!pending->looked_through) {
    const double bound = highest_confidence(terms(), "see_through", SurfaceKind::kCurved);
    if (bound < asked && !needs_all_evidence_) return bound;
    evidence.see_through = see_through(context_, samples_, open, Q, form);
    pending->looked_through = true;
  }
  return confidence(terms(), SurfaceKind::kCurved);
}

std::optional<Surface> CandidateJudge::plane_instead(Surface surface,
                                                     const Acceptance& asked) const {
  if (!asked.takes_planes_instead) return std::nullopt;
  return fit_plane(samples_, std::move(surface.region), options_);
}

bool CandidateJudge::is_acceptable(const Surface& surface, const Acceptance& asked) const {
  if (!(surface.confidence >= asked_of(surface, asked))) return false;
  if (is_flat(surface)) {
    return static_cast<int>(surface.region.size()) >= options_.min_plane_samples;
  }
  return !(surface.rms > asked.max_residual * mean_sigma(samples_, surface.region));
}

/// @param asked  see quadrille::weigh(); whoever observes trials is told all evidence
void CandidateJudge::weigh(Surface* surface, const AcceptedSurfaces& accepted, double asked) const {
  quadrille::weigh(source(accepted), surface, around(surface->region, accepted),
                   needs_all_evidence_ ? 0.0 : asked);
}

/// Least confidence at which a surface is accepted.
double CandidateJudge::asked_of(const Surface& surface, const Acceptance& asked) const {
  return is_flat(surface) ? options_.min_plane_confidence : asked.min_confidence;
}

/// The samples that no surface has claimed, if no accepted surface nearby nearly explains the
/// region, which then is more than a flaw of that surface; otherwise all samples.
const Mask& CandidateJudge::around(std::span<const int> region,
                                   const AcceptedSurfaces& accepted) const {
  static const Mask kAll;
  const Normalisation local = normalisation_of(samples_, region);
  const std::vector<int> some = spread_evenly(region, kOffsetSamples);
  const bool is_flaw = std::any_of(
      accepted.places.begin(), accepted.places.end(), [&](const AcceptedSurfaces::Place& s) {
        return may_meet(s.local, local) &&
               rms_distance(s.Q, samples_, some) <= kMinOffset * s.local.scale;
      });
  return is_flaw ? kAll : accepted.claims.free();
}

}  // namespace quadrille
