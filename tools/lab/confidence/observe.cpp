#include "lab/confidence/observe.hpp"

#include <memory>
#include <optional>

#include "fit/family_spec.hpp"
#include "lab/scoring/score.hpp"
#include "planes/plane_claims.hpp"
#include "quadrille/detector/canonical.hpp"
#include "samples/cell_pyramid.hpp"
#include "surfaces/confidence.hpp"
#include "surfaces/find_surfaces.hpp"

namespace quadrille::confidence_training {
namespace {

/// The curved surfaces that the stages of detect() come to.
std::vector<Surface> surfaces_of(const PointCloud& cloud) {
  DetectorOptions options;
  options.aggregate.min_confidence = 0.0;
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  if (!pyramid) return {};
  const SurfaceSamples coarse = pyramid->coarse_samples();
  const std::vector<PlaneRegion> planes = find_planes(coarse, options.planes);
  const std::vector<char> keep = cells_off_planes(*pyramid, coarse, planes, options.planes.sigmas);
  const SampleTree tree(*pyramid, pyramid->samples(keep, options.threads));
  StageClock clock;
  std::vector<Surface> surfaces = find_surfaces(tree, options, clock).surfaces();
  std::erase_if(surfaces, [](const Surface& s) { return s.fit.family == Family::kPlane; });
  return surfaces;
}

std::optional<bool> is_right(const Surface& surface, const scoring::Frame& frame) {
  const scoring::FrameScore score = scoring::score(frame, {{surface.Q, 1.0}});
  if (score.found > 0) return true;
  if (score.wrong + score.planes_wrong > 0) return false;
  return std::nullopt;
}

}  // namespace

std::vector<Observation> observe(const scoring::Frame& frame) {
  std::vector<Observation> observations;
  for (const Surface& surface : surfaces_of(frame.cloud)) {
    const std::optional<bool> right = is_right(surface, frame);
    if (!right) continue;
    observations.push_back({confidence_terms(surface.evidence, family_spec(surface.fit.family).dof),
                            log_prior(canonical_form(surface.fit.posed).type), *right});
  }
  return observations;
}

}  // namespace quadrille::confidence_training
