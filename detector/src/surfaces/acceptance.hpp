#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Where in the search from coarse to fine a candidate comes from.
enum class SearchLevel {
  kCoarse,  ///< finer ones follow: what is in doubt is offered again
  kFinest,  ///< the last: what is refused here is lost
};

/// What a candidate has to show to become a surface. Residuals are rms distances in multiples of
/// the noise.
struct Acceptance {
  /// Confidence in the candidate's own fit: with less it is not worth a better one.
  double min_candidate_confidence;
  /// Residual of the better fit to the candidate's samples, whatever its family.
  double max_candidate_residual;
  /// Whether what turns out to be flat may become a plane; else it is refused.
  bool takes_planes_instead;
  /// Confidence in a curved surface, and its residual when it has been extended.
  double min_confidence, max_residual;
};

/// On coarse levels only clear cases are accepted, for they claim their samples before the finer
/// levels are searched.
Acceptance acceptance_at(SearchLevel level, const AggregateOptions& options);

}  // namespace quadrille
