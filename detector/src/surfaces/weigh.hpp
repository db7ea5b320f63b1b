#pragma once

#include <span>

#include "base/mask.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/claims.hpp"
#include "surfaces/evidence/sample_blocks.hpp"
#include "surfaces/evidence/scene_context.hpp"
#include "surfaces/surface.hpp"

namespace quadrille {

/// The data from which the evidence for surfaces is collected.
struct EvidenceSource {
  const SurfaceSamples& samples;
  const SampleBlocks& blocks;
  const SceneContext& context;
  /// The samples of accepted surfaces; null to weigh as if nothing else had been found.
  const Claims* claims;
};

/// The evidence for a quadric, which stays as it is while other surfaces claim samples. What
/// depends on them is set by look_around(). What is seen through the quadric is missing.
struct LastingEvidence {
  Evidence evidence;
  RegionBorder border;
};

/// Collects the lasting evidence for a quadric whose inliers are the region; see all_evidence().
LastingEvidence lasting_evidence(const EvidenceSource& from, std::span<const int> region,
                                 const Quadric& Q, const CanonicalForm& form);

/// Sets the evidence about what other surfaces leave around the region.
void look_around(const EvidenceSource& from, std::span<const int> region, const Mask& free,
                 LastingEvidence* evidence);

/// Collects all evidence for a quadric whose inliers are the region, which must not be empty, but
/// for what is seen through it.
/// @param form, free  as all_evidence() has them
Evidence evidence_on_surface(const EvidenceSource& from, std::span<const int> region,
                             const Quadric& Q, const CanonicalForm& form, const Mask& free);

/// Collects all evidence for a quadric whose inliers are the region, which must not be empty.
/// @param form    canonical form of the quadric, with its pose in frame C; its dimensions are not
/// used
/// @param free    samples that belong to no other surface
Evidence all_evidence(const EvidenceSource& from, std::span<const int> region, const Quadric& Q,
                      const CanonicalForm& form, const Mask& free = {});

/// Sets a surface's evidence and confidence.
/// @param asked  confidence below which a surface is of no interest: if no result of counting what
///   is seen through it, which takes long, can reach it, that evidence is left out, and the
///   confidence is an upper bound
void weigh(const EvidenceSource& from, Surface* surface, const Mask& free = {}, double asked = 0.0);

}  // namespace quadrille
