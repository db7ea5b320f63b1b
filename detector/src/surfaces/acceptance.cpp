#include "surfaces/acceptance.hpp"

#include <limits>

namespace quadrille {
namespace {

// On coarse levels a better fit is tried if the candidate reaches this share of the final
// confidence; rejected candidates are offered again on finer levels.
constexpr double kCoarseShare = 0.5;

}  // namespace

Acceptance acceptance_at(SearchLevel level, const AggregateOptions& options) {
  if (level == SearchLevel::kCoarse) {
    return {.min_candidate_confidence = kCoarseShare * options.min_confidence_early,
            .max_candidate_residual = options.max_residual_early,
            .takes_planes_instead = false,
            .min_confidence = options.min_confidence_early,
            .max_residual = options.max_residual};
  }
  return {.min_candidate_confidence = options.min_first_look,
          .max_candidate_residual = std::numeric_limits<double>::infinity(),
          .takes_planes_instead = true,
          .min_confidence = options.min_confidence,
          .max_residual = options.max_residual};
}

}  // namespace quadrille
