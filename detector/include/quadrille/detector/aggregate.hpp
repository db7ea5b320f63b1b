#pragma once

#include <vector>

#include "quadrille/detector/evidence.hpp"
#include "quadrille/detector/model_selection.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/search.hpp"

namespace quadrille {

struct AggregateOptions {
  /// Share of a candidate's samples that no better one has claimed.
  double least_open = 0.5;
  /// Samples of a surface at least.
  int least_samples = 30;
  /// Points that a fit uses at most.
  int fit_points = 600;
  /// Independent measurements per sample.
  double effective_share = 0.0625;
  InlierTest inlier;
  /// Factor on the distance within which an accepted quadric claims further samples.
  double claim = 1.3;
};

/// A surface of the scene: one fitted quadric and the samples on it.
struct Surface {
  Quadric Q;
  /// In frame C; empty for planes found before.
  FamilyFit fit;
  Normalisation local;
  std::vector<int> region;
  double rms = 0.0, score = 0.0;
  Evidence evidence;
};

/// Chooses among overlapping candidates (paper, "Hypotheses aggregation"): the one that explains
/// most comes first, refits itself to all it explains, connected or not, and claims it.
/// @param candidates  with regions in terms of `samples`
std::vector<Surface> aggregate(const SurfaceSamples& samples, std::vector<Candidate> candidates,
                               const AggregateOptions& options);

}  // namespace quadrille
