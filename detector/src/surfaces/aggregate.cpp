#include "surfaces/aggregate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "base/try_ahead.hpp"
#include "samples/inliers.hpp"
#include "surfaces/join.hpp"
#include "surfaces/plane_surface.hpp"
#include "surfaces/sibling.hpp"
#include "surfaces/two_pieces.hpp"
#include "surfaces/two_walls.hpp"

namespace quadrille {
namespace {

// Gain in the Bayesian information criterion from which on the evidence is very strong, by Kass and
// Raftery, "Bayes factors" (1995). Two pieces that nothing else speaks for need it.
constexpr double kStrongGain = 10.0;

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
  using State = AcceptedSurfaces;
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

  const AcceptedSurfaces& state() const { return to_.accepted_; }
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
  Trial attempt(int step, const AcceptedSurfaces& accepted, Scratch* /*none*/) {
    return to_.judge_.try_out(&to_.pending_[step], asked_, accepted);
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
      observer_(std::move(observer)),
      threads_(threads),
      judge_(samples, options, inlier, std::move(context), static_cast<bool>(observer_)),
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
    judge_.weigh(&surface, accepted_);
    if (surface.confidence < options_.min_plane_confidence) continue;
    accept(std::move(surface));
  }
}

void Aggregation::divide() {
  for (std::size_t k = surfaces_.size(); k-- > 0;) {
    const Surface* const sibling = sibling_of(surfaces_[k], surfaces_, samples_);
    std::optional<TwoPieces> pieces =
        two_pieces(surfaces_[k], sibling, samples_, accepted_.claims.free(), options_);
    if (!pieces) continue;
    const auto is_large = [&](const Surface& piece) {
      return static_cast<int>(piece.region.size()) >= options_.min_samples;
    };
    if (!is_large(pieces->cylinder) && !is_large(pieces->cone)) continue;
    judge_.weigh(&pieces->cylinder, accepted_);
    judge_.weigh(&pieces->cone, accepted_);
    if (!sibling && pieces->gain < kStrongGain &&
        pieces->cylinder.confidence < options_.min_confidence) {
      continue;
    }
    // The pieces explain the samples better than a credible surface does.
    const double least = surfaces_[k].confidence;
    remove(k);
    for (Surface* piece : {&pieces->cylinder, &pieces->cone}) {
      if (!is_large(*piece)) continue;
      piece->confidence = std::max(piece->confidence, least);
      accept(std::move(*piece));
    }
  }
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
    remove(k);
    if (std::optional<TwoWalls> walls = two_walls(*joint, samples_, options_)) {
      judge_.weigh(&walls->down, accepted_);
      judge_.weigh(&walls->up, accepted_);
      result.push_back(std::move(walls->down));
      surface = std::move(walls->up);
      continue;
    }
    judge_.weigh(&*joint, accepted_);
    surface = std::move(*joint);
    surface.confidence = std::max(min_confidence, surface.confidence);
  }
  result.push_back(std::move(surface));
  return result;
}

/// Removes an accepted surface; its samples stay claimed.
void Aggregation::remove(std::size_t surface) {
  const auto k = static_cast<std::ptrdiff_t>(surface);
  surfaces_.erase(surfaces_.begin() + k);
  accepted_.places.erase(accepted_.places.begin() + k);
}

void Aggregation::accept(Surface surface) {
  accepted_.claims.add(surface.region);
  accepted_.places.push_back({surface.Q, surface.local});
  surfaces_.push_back(std::move(surface));
}

}  // namespace quadrille
