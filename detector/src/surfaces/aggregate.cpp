#include "surfaces/aggregate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fit/family_spec.hpp"
#include "samples/inliers.hpp"
#include "surfaces/effective_share.hpp"

namespace quadrille {
namespace {

constexpr int kIterations = 6;
// A candidate whose own fit is less credible than this is not worth a better one.
constexpr double kHopeless = 0.1;
// Before the better fit, the spread is allowed to be this much smaller.
constexpr double kNearlyFlat = 0.8;
// Share of its extent that a surface is looked for beyond each end.
constexpr float kFurther = 0.15f;
// A region is a surface of its own if it lies this share of their sizes off all surfaces about it:
// flaws of real cups and posts reach .05 of theirs, and a dome lies .12 off its post.
constexpr double kOwn = 0.08;
// Samples of a region that tell whether it lies off.
constexpr std::size_t kWitnesses = 100;
// A fit to a larger region may be this much worse than that to the smaller.
constexpr double kLargerRms = 1.3;
// Surfaces whose centres lie farther apart than this, in multiples of their sizes, do not meet.
constexpr double kReach = 2.5;
// A joint fit may be this much worse than the worse of two.
constexpr double kJointRms = 1.25;

/// Area explained, weighted by how well: a truncated quadratic in the distance.
double support(const SurfaceSamples& samples, const Candidate& candidate, const InlierTest& test,
               const std::vector<char>& claimed) {
  const Eigen::Matrix4f Q = candidate.Q.matrix().cast<float>();
  const float sigmas = static_cast<float>(test.sigmas);
  float sum = 0;
  for (const int i : candidate.region) {
    if (claimed[i]) continue;
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

bool may_meet(const Normalisation& a, const Normalisation& b) {
  return (a.centre - b.centre).norm() < kReach * (a.scale + b.scale);
}

}  // namespace

Aggregation::Aggregation(const SurfaceSamples& samples, const AggregateOptions& options,
                         const InlierTest& inlier)
    : samples_(samples), options_(options), inlier_(inlier), buckets_(samples), parts_(samples) {}

void Aggregation::offer(std::vector<Candidate> candidates, bool early) {
  for (Candidate& c : candidates) pending_.push_back(std::move(c));
  std::vector<double> value;
  std::vector<Eigen::AlignedBox3f> box;
  for (const Candidate& c : pending_) {
    value.push_back(support(samples_, c, inlier_, claimed()));
    box.push_back(box_of(samples_, c.region));
  }
  std::vector<Candidate> later;
  while (true) {
    const auto best = std::max_element(value.begin(), value.end());
    if (best == value.end() || *best <= 0) break;
    Candidate& candidate = pending_[static_cast<std::size_t>(best - value.begin())];
    *best = 0;
    std::optional<Surface> surface = accept(candidate, early);
    if (!surface) {
      if (early) later.push_back(std::move(candidate));
      continue;
    }
    parts_.claim(surface->region);
    const Eigen::AlignedBox3f claim = box_of(samples_, surface->region);
    surfaces_.push_back(std::move(*surface));
    for (std::size_t c = 0; c < pending_.size(); ++c) {
      if (value[c] > 0 && box[c].intersects(claim))
        value[c] = support(samples_, pending_[c], inlier_, claimed());
    }
  }
  pending_ = std::move(later);
}

std::optional<Surface> Aggregation::accept(const Candidate& candidate, bool early) {
  std::vector<int> open;
  for (const int i : candidate.region) {
    if (!claimed()[i]) open.push_back(i);
  }
  const double size = static_cast<double>(candidate.region.size());
  if (static_cast<int>(open.size()) < options_.min_samples ||
      static_cast<double>(open.size()) < options_.min_open * size) {
    return std::nullopt;
  }
  const double least = early ? options_.min_confidence_early : options_.min_confidence;
  const bool flat = candidate.family == Family::kPlane;
  if (!flat) {
    const Evidence evidence = evidence_of(open, candidate.Q);
    const double hope = confidence(evidence, family_spec(candidate.family).dof);
    const bool curved = evidence.spread >= kNearlyFlat * options_.min_spread;
    if (curved ? !(hope >= (early ? 0.5 * least : kHopeless)) : early) return std::nullopt;
  }
  std::optional<Surface> surface = fitted(std::move(open));
  // The general fit of a plane is a doubled plane.
  if (surface && is_thin(*surface, samples_)) {
    surface = early ? std::nullopt : as_plane(std::move(surface->region));
  }
  if (!surface) return std::nullopt;
  if (early && surface->rms > options_.max_residual_early * mean_sigma(samples_, surface->region)) {
    return std::nullopt;
  }
  extend(&*surface);
  if (is_thin(*surface, samples_)) return std::nullopt;
  surface->evidence = evidence_of(surface->region, surface->Q);
  surface->confidence = confidence_of(*surface);
  // What hardly bends is reported as the plane that it nearly is.
  if (surface->fit.family != Family::kPlane && surface->evidence.spread < options_.min_spread) {
    surface = early ? std::nullopt : as_plane(std::move(surface->region));
    if (!surface) return std::nullopt;
  }
  const bool plane = surface->fit.family == Family::kPlane;
  if (plane && static_cast<int>(surface->region.size()) < options_.min_plane_samples) {
    return std::nullopt;
  }
  if (!plane && (!(surface->confidence >= least) ||
                 surface->rms > options_.max_residual * mean_sigma(samples_, surface->region))) {
    return std::nullopt;
  }
  join(&*surface);
  return surface;
}

std::optional<Surface> Aggregation::fitted(std::vector<int> region) const {
  Surface surface;
  surface.local = normalisation_of(samples_, region);
  const OrientedPointsf points = fit_points(samples_, region, surface.local, options_.fit_points);
  const std::optional<FamilyFit> general = fit_family(points, Family::kGeneral, kIterations);
  if (!general) return std::nullopt;
  const double share =
      effective_share(samples_, region, surface.local.to_frame(general->posed.matrix()));
  surface.effective_size =
      std::min(options_.effective_size,
               std::min(share, options_.effective_share) * static_cast<double>(region.size()));
  SelectionOptions selection_options;
  selection_options.iterations = kIterations;
  selection_options.effective_share = surface.effective_size / static_cast<double>(points.size());
  selection_options.common_noise =
      samples_.common_noise * mean_sigma(samples_, region) / surface.local.scale;
  Selection selection = select_family(points, options_.families, *general, selection_options);
  surface.Q = surface.local.to_frame(selection.best.posed.matrix()).normalized();
  surface.rms =
      surface.local.scale * std::sqrt(selection.best.rss / static_cast<double>(points.size()));
  surface.fit = std::move(selection.best);
  surface.region = std::move(region);
  return surface;
}

/// The region as a plane with its evidence; nullopt if the noise does not explain its residual.
std::optional<Surface> Aggregation::as_plane(std::vector<int> region) const {
  Surface surface;
  surface.local = normalisation_of(samples_, region);
  const OrientedPointsf points = fit_points(samples_, region, surface.local, options_.fit_points);
  std::optional<FamilyFit> fit = fit_family(points, Family::kPlane, kIterations);
  if (!fit) return std::nullopt;
  surface.Q = surface.local.to_frame(fit->posed.matrix()).normalized();
  surface.rms = surface.local.scale * std::sqrt(fit->rss / static_cast<double>(points.size()));
  if (surface.rms > options_.max_residual_plane * mean_sigma(samples_, region)) {
    return std::nullopt;
  }
  surface.effective_size = std::min(options_.effective_size,
                                    options_.effective_share * static_cast<double>(region.size()));
  surface.fit = std::move(*fit);
  surface.evidence = evidence_of(region, surface.Q);
  surface.confidence = confidence_of(surface);
  surface.region = std::move(region);
  return surface;
}

Evidence Aggregation::evidence_of(std::span<const int> region, const Quadric& Q) const {
  Evidence evidence = collect_evidence(
      samples_, region, Q,
      stands_off(region) ? std::span<const char>(claimed()) : std::span<const char>());
  evidence.remainder = parts_.remainder(region);
  return evidence;
}

/// True if no accepted surface about it nearly explains the region: it is more than a flaw of one.
bool Aggregation::stands_off(std::span<const int> region) const {
  const Normalisation local = normalisation_of(samples_, region);
  const std::vector<int> some = spread_evenly(region, kWitnesses);
  return std::none_of(surfaces_.begin(), surfaces_.end(), [&](const Surface& s) {
    return may_meet(s.local, local) && rms_distance(s, samples_, some) <= kOwn * s.local.scale;
  });
}

/// Adds all open samples within the quadric's extent that lie on it, and refits if they are many:
/// the other side of an occluder, the inside of a bowl.
void Aggregation::extend(Surface* surface) const {
  const std::vector<int> more = further(*surface);
  std::vector<int> all = surface->region;
  all.insert(all.end(), more.begin(), more.end());
  if (more.size() > surface->region.size() / 50) {
    std::optional<Surface> refit = fitted(all);
    // A small region's fit can follow its noise: what the noise explains is no worse.
    const double noise = mean_sigma(samples_, all);
    if (refit && refit->rms < std::max(kLargerRms * surface->rms, noise)) {
      *surface = std::move(*refit);
      return;
    }
  }
  surface->region = std::move(all);
}

double Aggregation::bic_of(const Surface& surface, double effective_size) const {
  FamilyFit whole = surface.fit;
  whole.points = static_cast<int>(surface.region.size());
  // No fit is better than another that the noise explains.
  const double rms = std::max(surface.rms, mean_sigma(samples_, surface.region));
  whole.rss = rms * rms * whole.points;
  SelectionOptions selection_options;
  selection_options.effective_share = effective_size / whole.points;
  return bic(whole, selection_options);
}

/// Joins the surface with earlier ones where one quadric explains both.
void Aggregation::join(Surface* surface) {
  const auto is_flat = [](const Surface& s) { return s.fit.family == Family::kPlane; };
  for (std::size_t k = 0; k < surfaces_.size();) {
    const Surface& other = surfaces_[k];
    bool joined = false;
    if (is_flat(*surface) == is_flat(other) && may_meet(surface->local, other.local)) {
      std::vector<int> all = other.region;
      all.insert(all.end(), surface->region.begin(), surface->region.end());
      std::optional<Surface> joint = fitted(std::move(all));
      joined = joint && is_flat(*joint) == is_flat(other) && !is_thin(*joint, samples_) &&
               joint->rms < kJointRms * std::max(surface->rms, other.rms) &&
               bic_of(*joint, surface->effective_size + other.effective_size) <
                   bic_of(*surface, surface->effective_size) + bic_of(other, other.effective_size);
      if (joined) {
        const double least = std::max(surface->confidence, other.confidence);
        surfaces_.erase(surfaces_.begin() + static_cast<std::ptrdiff_t>(k));
        joint->evidence = evidence_of(joint->region, joint->Q);
        joint->confidence = std::max(least, confidence_of(*joint));
        *surface = std::move(*joint);
      }
    }
    if (!joined) ++k;
  }
}

std::vector<int> Aggregation::further(const Surface& surface) const {
  const Eigen::Isometry3f Y = surface.fit.posed.X.inverse().cast<float>();
  const Eigen::Vector3f centre = surface.local.centre.cast<float>();
  const float scale = static_cast<float>(surface.local.scale);
  const auto posed = [&](int i) -> Eigen::Vector3f {
    return Y * Eigen::Vector3f((samples_.raw[i] - centre) / scale);
  };
  std::vector<char> inside(samples_.p.size(), 0);
  Eigen::AlignedBox3f box;
  float farthest = 0;
  for (const int i : surface.region) {
    inside[i] = 1;
    box.extend(posed(i));
    farthest = std::max(farthest, (samples_.raw[i] - centre).squaredNorm());
  }
  const Eigen::Vector3f margin = kFurther * box.sizes();
  box.extend(Eigen::Vector3f(box.min() - margin));
  box.extend(Eigen::Vector3f(box.max() + margin));
  // The box lies within this ball.
  const float reach = std::sqrt(farthest) + margin.norm() * scale;
  InlierTest test = inlier_;
  test.sigmas *= options_.claim;
  const Eigen::Matrix4f Q = surface.Q.matrix().cast<float>();
  std::vector<int> more;
  for (const int i : buckets_.near(centre, reach)) {
    if (claimed()[i] || inside[i] || (samples_.raw[i] - centre).squaredNorm() > reach * reach) {
      continue;
    }
    if (is_inlier(samples_, i, Q, test) && box.contains(posed(i))) more.push_back(i);
  }
  return more;
}

}  // namespace quadrille
