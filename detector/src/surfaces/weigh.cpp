#include "surfaces/weigh.hpp"

#include "surfaces/evidence/axis_neighbours.hpp"
#include "surfaces/evidence/intruders.hpp"
#include "surfaces/evidence/see_through.hpp"
#include "surfaces/evidence/upright.hpp"

namespace quadrille {
namespace {

/// The quadric's axis; for a type without one, the upright line through its centre.
Axis axis_of(const CanonicalForm& form, const std::optional<Eigen::Vector3d>& up) {
  const bool upright = up && !has_axis(form.type);
  return {form.X.translation(), upright ? *up : Eigen::Vector3d(form.X.linear().col(2))};
}

}  // namespace

LastingEvidence lasting_evidence(const EvidenceSource& from, std::span<const int> region,
                                 const Quadric& Q, const CanonicalForm& form) {
  LastingEvidence result;
  Evidence& evidence = result.evidence;
  evidence = collect_evidence(from.samples, region, Q, &result.border);
  add_intruders(from.samples, from.blocks, region, Q, &evidence);
  evidence.uprightness = uprightness(form, from.context.up);
  const AxisNeighbours about =
      axis_neighbours(from.samples, from.blocks, region, axis_of(form, from.context.up));
  evidence.meet_axis = about.meet;
  evidence.miss_axis = about.miss;
  return result;
}

void look_around(const EvidenceSource& from, std::span<const int> region, const Mask& free,
                 LastingEvidence* evidence) {
  evidence->evidence.smooth_border = evidence->border.smooth_share(free);
  if (from.claims) evidence->evidence.remainder = from.claims->remainder(region);
}

Evidence evidence_on_surface(const EvidenceSource& from, std::span<const int> region,
                             const Quadric& Q, const CanonicalForm& form, const Mask& free) {
  LastingEvidence result = lasting_evidence(from, region, Q, form);
  look_around(from, region, free, &result);
  return result.evidence;
}

Evidence all_evidence(const EvidenceSource& from, std::span<const int> region, const Quadric& Q,
                      const CanonicalForm& form, const Mask& free) {
  Evidence evidence = evidence_on_surface(from, region, Q, form, free);
  evidence.see_through = see_through(from.context, from.samples, region, Q, form);
  return evidence;
}

void weigh(const EvidenceSource& from, Surface* surface, const Mask& free, double asked) {
  const SurfaceKind kind = is_flat(*surface) ? SurfaceKind::kFlat : SurfaceKind::kCurved;
  const CanonicalForm form = form_of(*surface);
  surface->evidence = evidence_on_surface(from, surface->region, surface->Q, form, free);
  if (asked > 0.0) {
    surface->confidence = highest_confidence(terms_of(*surface), "see_through", kind);
    if (surface->confidence < asked) return;
  }
  surface->evidence.see_through =
      see_through(from.context, from.samples, surface->region, surface->Q, form);
  surface->confidence = confidence(terms_of(*surface), kind);
}

}  // namespace quadrille
