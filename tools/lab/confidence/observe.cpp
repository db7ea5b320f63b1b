#include "lab/confidence/observe.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "base/stage_clock.hpp"
#include "lab/scoring/score.hpp"
#include "lab/trials/search_samples.hpp"
#include "planes/planes.hpp"
#include "surfaces/find_surfaces.hpp"
#include "surfaces/plane_surface.hpp"

namespace quadrille::confidence_training {
namespace {

/// Returns whether a surface is right; nullopt if it is neither right nor wrong.
std::optional<bool> is_right(scoring::Verdict verdict, bool flat) {
  switch (verdict) {
    case scoring::Verdict::kRight:
      return flat ? std::nullopt : std::optional(true);
    case scoring::Verdict::kPlane:
      return flat ? std::optional(true) : std::nullopt;
    case scoring::Verdict::kHardlyVisible:
      return std::nullopt;
    case scoring::Verdict::kNoPlane:
    case scoring::Verdict::kWrong:
      return false;
  }
  return std::nullopt;
}

/// Returns all surfaces that the detector weighs.
std::vector<Surface> weighed_surfaces(const trials::SearchSamples& found,
                                      const DetectorOptions& options) {
  std::vector<Surface> weighed = weighed_planes(found.coarse, found.planes, found.context);
  StageClock clock;
  const auto take_curved = [&](const Candidate&, SearchLevel, const Trial& trial) {
    if (trial.end >= TrialEnd::kConfidence && !is_flat(*trial.surface)) {
      weighed.push_back(*trial.surface);
    }
  };
  const Aggregation aggregation =
      find_surfaces(*found.tree, found.context, options, clock, take_curved);
  for (const Surface& surface : aggregation.surfaces()) {
    if (is_flat(surface)) weighed.push_back(surface);
  }
  return weighed;
}

}  // namespace

std::vector<Observation> observe(const scoring::Frame& frame, DetectorOptions options) {
  // Surfaces that are refused before they are weighed would teach nothing, so none is refused.
  options.aggregate.min_first_look = 0.0;
  options.aggregate.min_plane_confidence = 0.0;
  const std::optional<trials::SearchSamples> samples = trials::search_samples(frame.cloud, options);
  if (!samples) return {};
  const std::vector<Surface> surfaces = weighed_surfaces(*samples, options);
  std::vector<Quadric> quadrics;
  for (const Surface& surface : surfaces) quadrics.push_back(surface.Q);
  const std::vector<scoring::Judgement> judgements = scoring::judge_each(frame, quadrics);
  std::vector<Observation> observations;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const bool flat = is_flat(surfaces[k]);
    const std::optional<bool> right = is_right(judgements[k].verdict, flat);
    if (right) observations.push_back({terms_of(surfaces[k]), flat, *right});
  }
  return observations;
}

}  // namespace quadrille::confidence_training
