#include "surfaces/weigh.hpp"

#include "surfaces/evidence/intruders.hpp"
#include "surfaces/evidence/see_through.hpp"
#include "surfaces/evidence/upright.hpp"

namespace quadrille {

Evidence all_evidence(const EvidenceSource& from, std::span<const int> region, const Quadric& Q,
                      const CanonicalForm& form, const Mask& free) {
  Evidence evidence = collect_evidence(from.samples, region, Q, free);
  if (from.claims) evidence.remainder = from.claims->remainder(region);
  add_intruders(from.samples, from.buckets, region, Q, &evidence);
  evidence.uprightness = uprightness(form, from.context.up);
  evidence.see_through = see_through(from.context, from.samples, region, Q, form);
  return evidence;
}

void weigh(const EvidenceSource& from, Surface* surface, const Mask& free) {
  const CanonicalForm form = canonical_form(surface->fit.posed);
  surface->evidence = all_evidence(from, surface->region, surface->Q, form, free);
  surface->confidence =
      confidence(terms_of(*surface), is_flat(*surface) ? SurfaceKind::kFlat : SurfaceKind::kCurved);
}

}  // namespace quadrille
