#pragma once

#include "quadrille/detector/stage_options.hpp"

namespace quadrille {

/// Level of the search from coarse to fine at which a candidate was found.
enum class SearchLevel {
  kCoarse,  ///< finer levels follow, so a doubtful candidate is offered again
  kFinest,  ///< the last level, so a refused candidate is lost
};

/// Requirements on a candidate. Residuals are rms distances in multiples of the noise.
struct Acceptance {
  /// Least confidence in the candidate's own fit; below it, no better fit is tried.
  double min_candidate_confidence;
  /// Largest residual of the better fit to the candidate's samples, whatever its family.
  double max_candidate_residual;
  /// If true, a candidate that turns out to be flat may become a plane; otherwise it is refused.
  bool takes_planes_instead;
  /// Least confidence in a curved surface, and largest residual after it has been extended.
  double min_confidence, max_residual;
};

/// Returns the requirements at a level. On coarse levels they are strict, since accepted surfaces
/// claim their samples before finer levels are searched.
Acceptance acceptance_at(SearchLevel level, const AggregateOptions& options);

}  // namespace quadrille
