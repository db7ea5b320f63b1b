#include "surfaces/acceptance.hpp"

#include <limits>

namespace quadrille {
namespace {

// The better fit raises the confidence of many a candidate, to twice and more: on coarse levels it
// is tried from half the confidence that is asked for in the end, and on the last one, where
// nothing follows, from nearly none.
constexpr double kCoarseShare = 0.5, kMinFinestConfidence = 0.1;

}  // namespace

Acceptance acceptance_at(SearchLevel level, const AggregateOptions& options) {
  if (level == SearchLevel::kCoarse) {
    return {.min_candidate_confidence = kCoarseShare * options.min_confidence_early,
            .max_candidate_residual = options.max_residual_early,
            .takes_planes_instead = false,
            .min_confidence = options.min_confidence_early,
            .max_residual = options.max_residual};
  }
  return {.min_candidate_confidence = kMinFinestConfidence,
          .max_candidate_residual = std::numeric_limits<double>::infinity(),
          .takes_planes_instead = true,
          .min_confidence = options.min_confidence,
          .max_residual = options.max_residual};
}

}  // namespace quadrille
