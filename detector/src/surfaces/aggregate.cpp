#include "surfaces/aggregate.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/try_ahead.hpp"
#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/inliers.hpp"
#include "surfaces/evidence/see_through.hpp"
#include "surfaces/join.hpp"
#include "surfaces/plane_surface.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/two_walls.hpp"

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

/// The candidates of an offer, whose trials are steps for take_steps().
class Aggregation::Offer {
 public:
  using State = Accepted;
  struct Scratch {};
  using Outcome = Trial;
  static constexpr std::size_t kTriesPerThread = 4;

  Offer(Aggregation* to, SearchLevel level, const std::function<bool(const Surface&)>& doubts)
      : to_(*to), level_(level), asked_(acceptance_at(level, to->options_)), doubts_(doubts) {
    for (const PendingCandidate& c : to_.pending_) {
      value_.push_back(value_of(c));
      box_.push_back(box_of(to_.samples_, c.candidate.region));
    }
    begun_.assign(value_.size(), 0);
  }

  const Accepted& state() const { return to_.accepted_; }
  Scratch scratch() const { return {}; }
  /// The candidate that explains most.
  std::optional<int> first() const {
    const auto best = std::max_element(value_.begin(), value_.end());
    if (best == value_.end() || *best <= 0) return std::nullopt;
    return static_cast<int>(best - value_.begin());
  }
  /// The first candidate, or one of those after it if that was begun. The others come last that lie
  /// where one is being tried: if that is accepted, it leaves little of them to try.
  std::optional<int> begin_next() {
    std::optional<int> next = first();
    if (next && begun_[*next]) next = best_of([&](std::size_t c) { return is_apart(c); });
    if (!next) next = best_of([](std::size_t) { return true; });
    if (next) begun_[*next] = 1;
    return next;
  }
  bool is_left(int step) const { return value_[step] > 0; }
  Trial attempt(int step, const Accepted& accepted, Scratch* /*none*/) {
    return to_.try_out(&to_.pending_[step], asked_, accepted);
  }
  /// Another surface may change the evidence. Most of the work is remembered by the candidate.
  bool holds(int /*step*/, const Trial& /*trial*/) const { return false; }
  bool take(int step, Trial trial) {
    PendingCandidate& pending = to_.pending_[step];
    value_[step] = 0;
    if (to_.observer_) to_.observer_(pending.candidate, level_, trial);
    if (trial.end != TrialEnd::kAccepted) {
      if (level_ == SearchLevel::kCoarse) later_.push_back(std::move(pending));
      return false;
    }
    if (doubts_ && doubts_(*trial.surface)) {
      doubtful_.push_back(std::move(pending.candidate));
      return false;
    }
    Eigen::AlignedBox3f claim;
    for (Surface& surface : to_.joined(std::move(*trial.surface))) {
      claim.extend(box_of(to_.samples_, surface.region));
      to_.accept(std::move(surface));
    }
    for (std::size_t c = 0; c < value_.size(); ++c) {
      if (value_[c] > 0 && box_[c].intersects(claim)) value_[c] = value_of(to_.pending_[c]);
    }
    return true;
  }

  /// The refused candidates of a coarse level, and those that were doubted.
  std::vector<PendingCandidate> take_later() { return std::move(later_); }
  std::vector<Candidate> take_doubtful() { return std::move(doubtful_); }

 private:
  /// The candidate that explains most among those that were not begun and pass a test.
  template <class Test>
  std::optional<int> best_of(const Test& test) const {
    std::optional<int> best;
    for (std::size_t c = 0; c < value_.size(); ++c) {
      if (begun_[c] || value_[c] <= (best ? value_[*best] : 0.0) || !test(c)) continue;
      best = static_cast<int>(c);
    }
    return best;
  }

  /// True if no candidate lies near that is being tried.
  bool is_apart(std::size_t candidate) const {
    for (std::size_t c = 0; c < value_.size(); ++c) {
      if (begun_[c] && value_[c] > 0 && box_[c].intersects(box_[candidate])) return false;
    }
    return true;
  }

  double value_of(const PendingCandidate& c) const {
    return support(to_.samples_, c.candidate, to_.inlier_, to_.free());
  }

  Aggregation& to_;
  SearchLevel level_;
  Acceptance asked_;
  const std::function<bool(const Surface&)>& doubts_;
  /// Per candidate, what it explains, 0 after its trial; the box around its samples; and whether
  /// its trial has begun.
  std::vector<double> value_;
  std::vector<Eigen::AlignedBox3f> box_;
  Mask begun_;
  std::vector<PendingCandidate> later_;
  std::vector<Candidate> doubtful_;
};

Aggregation::Aggregation(const SurfaceSamples& samples, const AggregateOptions& options,
                         const InlierTest& inlier, SceneContext context, TrialObserver observer,
                         int threads)
    : samples_(samples),
      options_(options),
      inlier_(inlier),
      context_(std::move(context)),
      observer_(std::move(observer)),
      threads_(threads),
      blocks_(samples),
      extender_(samples, blocks_, options, inlier),
      accepted_{Claims(samples), {}} {}

void Aggregation::offer(std::vector<Candidate> candidates, SearchLevel level,
                        const std::function<bool(const Surface&)>& doubts) {
  for (Candidate& c : candidates) pending_.emplace_back(std::move(c));
  Offer offered(this, level, doubts);
  take_steps(&offered, threads_);
  pending_ = offered.take_later();
  if (std::vector<Candidate> doubtful = offered.take_doubtful(); !doubtful.empty()) {
    offer(std::move(doubtful), level);
  }
}

void Aggregation::offer_planes(const std::vector<PlaneRegion>& planes) {
  for (const PlaneRegion& plane : planes) {
    if (static_cast<int>(plane.samples.size()) < options_.min_plane_samples) continue;
    Surface surface = plane_surface(samples_, plane);
    weigh(&surface, accepted_);
    if (surface.confidence < options_.min_plane_confidence) continue;
    accept(std::move(surface));
  }
}

/// Refits the candidate's open samples, extends the fit, and weighs its evidence.
Trial Aggregation::try_out(PendingCandidate* pending, const Acceptance& asked,
                           const Accepted& accepted) const {
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
bool Aggregation::is_promising(PendingCandidate* pending, const Acceptance& asked,
                               const Accepted& accepted, Trial* trial) const {
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
double Aggregation::first_confidence(PendingCandidate* pending, double asked,
                                     const Accepted& accepted) const {
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

/// Merges the surface with earlier ones that the same quadric explains, and removes those. If these
/// are the two walls of a body, they stay two.
/// @return the surface, and the other walls of its body
std::vector<Surface> Aggregation::joined(Surface surface) {
  std::vector<Surface> result;
  for (std::size_t k = 0; k < surfaces_.size();) {
    std::optional<Surface> joint = join(surface, surfaces_[k], samples_, options_);
    if (!joint) {
      ++k;
      continue;
    }
    // The union of two credible surfaces is no less credible than either.
    const double min_confidence = std::max(surface.confidence, surfaces_[k].confidence);
    surfaces_.erase(surfaces_.begin() + static_cast<std::ptrdiff_t>(k));
    accepted_.places.erase(accepted_.places.begin() + static_cast<std::ptrdiff_t>(k));
    if (std::optional<TwoWalls> walls = two_walls(*joint, samples_, options_)) {
      weigh(&walls->down, accepted_);
      weigh(&walls->up, accepted_);
      result.push_back(std::move(walls->down));
      surface = std::move(walls->up);
      continue;
    }
    weigh(&*joint, accepted_);
    surface = std::move(*joint);
    surface.confidence = std::max(min_confidence, surface.confidence);
  }
  result.push_back(std::move(surface));
  return result;
}

void Aggregation::accept(Surface surface) {
  accepted_.claims.add(surface.region);
  accepted_.places.push_back({surface.Q, surface.local});
  surfaces_.push_back(std::move(surface));
}

/// @param asked  see quadrille::weigh(); whoever observes trials is told all evidence
void Aggregation::weigh(Surface* surface, const Accepted& accepted, double asked) const {
  quadrille::weigh(source(accepted), surface, around(surface->region, accepted),
                   observer_ ? 0.0 : asked);
}

/// Least confidence at which a surface is accepted.
double Aggregation::asked_of(const Surface& surface, const Acceptance& asked) const {
  return is_flat(surface) ? options_.min_plane_confidence : asked.min_confidence;
}

/// The samples that no surface has claimed, if no accepted surface nearby nearly explains the
/// region, which then is more than a flaw of that surface; otherwise all samples.
const Mask& Aggregation::around(std::span<const int> region, const Accepted& accepted) const {
  static const Mask kAll;
  const Normalisation local = normalisation_of(samples_, region);
  const std::vector<int> some = spread_evenly(region, kOffsetSamples);
  const bool is_flaw =
      std::any_of(accepted.places.begin(), accepted.places.end(), [&](const Place& s) {
        return may_meet(s.local, local) &&
               rms_distance(s.Q, samples_, some) <= kMinOffset * s.local.scale;
      });
  return is_flaw ? kAll : accepted.claims.free();
}

}  // namespace quadrille
