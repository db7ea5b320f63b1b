#include "lab/confidence/observe.hpp"

#include <memory>
#include <optional>

#include "fit/family_spec.hpp"
#include "lab/scoring/score.hpp"
#include "planes/plane_claims.hpp"
#include "quadrille/detector/canonical.hpp"
#include "samples/cell_pyramid.hpp"
#include "surfaces/evidence/confidence.hpp"
#include "surfaces/find_surfaces.hpp"
#include "surfaces/surface_fit.hpp"

namespace quadrille::confidence_training {
namespace {

/// The samples that the stages before the search make of a cloud; null if they make none.
std::unique_ptr<SampleTree> samples_of(const PointCloud& cloud, const DetectorOptions& options) {
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  if (!pyramid) return nullptr;
  const SurfaceSamples coarse = pyramid->coarse_samples();
  const std::vector<PlaneRegion> planes = find_planes(coarse, options.planes);
  const std::vector<char> keep = cells_off_planes(*pyramid, coarse, planes, options.planes.sigmas);
  return std::make_unique<SampleTree>(*pyramid, pyramid->samples(keep, options.threads));
}

/// A candidate's better fit with its evidence, as if nothing else had been found; nullopt where the
/// detector asks for no confidence, because it is refused or flat.
std::optional<Surface> weighed(Candidate candidate, const SurfaceSamples& samples,
                               const Claims& claims, const AggregateOptions& options) {
  if (static_cast<int>(candidate.region.size()) < options.min_samples) return std::nullopt;
  std::optional<Surface> surface = fit_surface(samples, std::move(candidate.region), options);
  if (!surface || surface->fit.family == Family::kPlane || is_thin(*surface, samples)) {
    return std::nullopt;
  }
  surface->evidence = collect_evidence(samples, surface->region, surface->Q);
  surface->evidence.remainder = claims.remainder(surface->region);
  if (surface->evidence.spread < options.min_spread) return std::nullopt;
  return surface;
}

std::optional<bool> is_right(const Surface& surface, const scoring::Frame& frame) {
  const scoring::FrameScore score = scoring::score(frame, {{surface.Q, 1.0}});
  if (score.found > 0) return true;
  if (score.wrong + score.planes_wrong > 0) return false;
  return std::nullopt;
}

}  // namespace

std::vector<Observation> observe(const scoring::Frame& frame) {
  const DetectorOptions options;
  const std::unique_ptr<SampleTree> tree = samples_of(frame.cloud, options);
  if (!tree) return {};
  const Claims claims(tree->finest());
  std::vector<Observation> observations;
  for (int level = 0; level < kLevels; ++level) {
    std::vector<char> open(static_cast<std::size_t>(tree->level(level).size()), 1);
    for (Candidate& candidate : find_candidates(*tree, level, std::move(open), options)) {
      const auto surface = weighed(std::move(candidate), tree->finest(), claims, options.aggregate);
      if (!surface) continue;
      const std::optional<bool> right = is_right(*surface, frame);
      if (!right) continue;
      const int dof = family_spec(surface->fit.family).dof;
      observations.push_back({confidence_terms(surface->evidence, dof),
                              log_prior(canonical_form(surface->fit.posed).type), *right});
    }
  }
  return observations;
}

}  // namespace quadrille::confidence_training
