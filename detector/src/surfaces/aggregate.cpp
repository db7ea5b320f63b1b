#include "surfaces/aggregate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

/// The area that a candidate explains, weighted by the quality of fit: a truncated quadratic in the
/// distance.
double support(const SurfaceSamples& samples, const Candidate& candidate, const InlierTest& test,
               const Mask& free) {
  const Eigen::Matrix4f Q = candidate.Q.matrix().cast<float>();
  const float sigmas = static_cast<float>(test.sigmas);
  float sum = 0;
  for (const int i : candidate.region) {
    if (!free[i]) continue;
    const float d = distance_to(Q, samples.raw[i]) / (sigmas * samples.sigma[i]);
    sum += std::max(0.0f, 1.0f - d * d) * samples.cell[i] * samples.cell[i];
  }
  return sum;
}

Eigen::AlignedBox3f box_of(const SurfaceSamples& samples, const std::vector<int>& region) {
  Eigen::AlignedBox3f box;
  for (const int i : region) box.extend(samples.raw[i]);
  return box;
}

}  // namespace

Aggregation::Aggregation(const SurfaceSamples& samples, const AggregateOptions& options,
                         const InlierTest& inlier, SceneContext context, TrialObserver observer)
    : samples_(samples),
      options_(options),
      inlier_(inlier),
      context_(std::move(context)),
      observer_(std::move(observer)),
      blocks_(samples),
      extender_(samples, blocks_, options, inlier),
      claims_(samples) {}

void Aggregation::offer(std::vector<Candidate> candidates, SearchLevel level,
                        const std::function<bool(const Surface&)>& doubts) {
  const Acceptance asked = acceptance_at(level, options_);
  for (Candidate& c : candidates) pending_.emplace_back(std::move(c));
  std::vector<double> value;
  std::vector<Eigen::AlignedBox3f> box;
  for (const PendingCandidate& c : pending_) {
    value.push_back(support(samples_, c.candidate, inlier_, free()));
    box.push_back(box_of(samples_, c.candidate.region));
  }
  std::vector<PendingCandidate> later;
  std::vector<Candidate> doubtful;
  while (true) {
    const auto best = std::max_element(value.begin(), value.end());
    if (best == value.end() || *best <= 0) break;
    PendingCandidate& pending = pending_[static_cast<std::size_t>(best - value.begin())];
    *best = 0;
    Trial trial = try_out(&pending, asked);
    if (observer_) observer_(pending.candidate, level, trial);
    if (trial.end != TrialEnd::kAccepted) {
      if (level == SearchLevel::kCoarse) later.push_back(std::move(pending));
      continue;
    }
    if (doubts && doubts(*trial.surface)) {
      doubtful.push_back(std::move(pending.candidate));
      continue;
    }
    const Surface& surface = surfaces_.emplace_back(joined(std::move(*trial.surface)));
    claims_.add(surface.region);
    const Eigen::AlignedBox3f claim = box_of(samples_, surface.region);
    for (std::size_t c = 0; c < pending_.size(); ++c) {
      if (value[c] > 0 && box[c].intersects(claim)) {
        value[c] = support(samples_, pending_[c].candidate, inlier_, free());
      }
    }
  }
  pending_ = std::move(later);
  if (!doubtful.empty()) offer(std::move(doubtful), level);
}

void Aggregation::offer_planes(const std::vector<PlaneRegion>& planes) {
  for (const PlaneRegion& plane : planes) {
    if (static_cast<int>(plane.samples.size()) < options_.min_plane_samples) continue;
    Surface surface = plane_surface(samples_, plane);
    weigh(&surface);
    if (surface.confidence < options_.min_plane_confidence) continue;
    claims_.add(surface.region);
    surfaces_.push_back(std::move(surface));
  }
}

/// Refits the candidate's open samples, extends the fit, and weighs its evidence.
Trial Aggregation::try_out(PendingCandidate* pending, const Acceptance& asked) const {
  Trial trial;
  if (!is_promising(pending, asked, &trial)) return trial;
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
  surface = extender_.extended(std::move(*surface), free());
  // The extended fit may differ, so it is checked again.
  if (is_thin(*surface, samples_)) return trial;
  weigh(&*surface, asked_of(*surface, asked));
  // A surface that hardly bends is reported as the plane that it nearly is.
  if (!is_flat(*surface) && surface->evidence.spread < options_.min_spread) {
    surface = plane_instead(std::move(*surface), asked);
    if (!surface) return trial;
    weigh(&*surface, asked_of(*surface, asked));
  }
  trial.end = is_acceptable(*surface, asked) ? TrialEnd::kAccepted : TrialEnd::kConfidence;
  return trial;
}

/// True if enough of a candidate's samples are open, and its own fit is good enough to try a better
/// one.
bool Aggregation::is_promising(PendingCandidate* pending, const Acceptance& asked,
                               Trial* trial) const {
  const Candidate& candidate = pending->candidate;
  pending->set_open(claims_.open_of(candidate.region));
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
  const double confidence = first_confidence(pending, asked.min_candidate_confidence);
  trial->first_look = pending->evidence->evidence;
  return confidence >= asked.min_candidate_confidence;
}

/// The confidence in a candidate's own fit, or an upper bound if that is less than what is asked.
/// Counting the points that were seen through the quadric takes longer than all other evidence. It
/// is left out if the candidate is refused for any result of it, as most are.
double Aggregation::first_confidence(PendingCandidate* pending, double asked) const {
  const auto& [Q, family, region, rms] = pending->candidate;
  const std::vector<int>& open = pending->open;
  const CanonicalForm form = canonical_form(Q);
  if (!pending->evidence) pending->evidence = lasting_evidence(source(), open, Q, form);
  look_around(source(), open, around(open), &*pending->evidence);
  Evidence& evidence = pending->evidence->evidence;
  const auto terms = [&, dof = family_spec(family).dof] {
    return confidence_terms(evidence, dof, log_prior(form.type));
  };
  if (!pending->looked_through) {
    const double bound = highest_confidence(terms(), "see_through", SurfaceKind::kCurved);
    if (bound < asked && !observer_) return bound;
    evidence.see_through = see_through(context_, samples_, open, Q, form);
    pending->looked_through = true;
  }
  return confidence(terms(), SurfaceKind::kCurved);
}

std::optional<Surface> Aggregation::plane_instead(Surface surface, const Acceptance& asked) const {
  if (!asked.takes_planes_instead) return std::nullopt;
  return fit_plane(samples_, std::move(surface.region), options_);
}

bool Aggregation::is_acceptable(const Surface& surface, const Acceptance& asked) const {
  if (!(surface.confidence >= asked_of(surface, asked))) return false;
  if (is_flat(surface)) {
    return static_cast<int>(surface.region.size()) >= options_.min_plane_samples;
  }
  return !(surface.rms > asked.max_residual * mean_sigma(samples_, surface.region));
}

/// Merges the surface with earlier ones that the same quadric explains, and removes those.
Surface Aggregation::joined(Surface surface) {
  for (std::size_t k = 0; k < surfaces_.size();) {
    std::optional<Surface> joint = join(surface, surfaces_[k], samples_, options_);
    if (!joint) {
      ++k;
      continue;
    }
    // The union of two credible surfaces is no less credible than either.
    const double min_confidence = std::max(surface.confidence, surfaces_[k].confidence);
    surfaces_.erase(surfaces_.begin() + static_cast<std::ptrdiff_t>(k));
    weigh(&*joint);
    joint->confidence = std::max(min_confidence, joint->confidence);
    surface = std::move(*joint);
  }
  return surface;
}

/// @param asked  see quadrille::weigh(); whoever observes trials is told all evidence
void Aggregation::weigh(Surface* surface, double asked) const {
  quadrille::weigh(source(), surface, around(surface->region), observer_ ? 0.0 : asked);
}

/// Least confidence at which a surface is accepted.
double Aggregation::asked_of(const Surface& surface, const Acceptance& asked) const {
  return is_flat(surface) ? options_.min_plane_confidence : asked.min_confidence;
}

/// The samples that no surface has claimed, if no accepted surface nearby nearly explains the
/// region, which then is more than a flaw of that surface; otherwise all samples.
const Mask& Aggregation::around(std::span<const int> region) const {
  static const Mask kAll;
  const Normalisation local = normalisation_of(samples_, region);
  const std::vector<int> some = spread_evenly(region, kOffsetSamples);
  const bool is_flaw = std::any_of(surfaces_.begin(), surfaces_.end(), [&](const Surface& s) {
    return may_meet(s.local, local) &&
           rms_distance(s, samples_, some) <= kMinOffset * s.local.scale;
  });
  return is_flaw ? kAll : free();
}

}  // namespace quadrille
