#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"
#include "search/candidate.hpp"

namespace quadrille {

/// Thresholds of the paper's clustering of hypotheses ("Hypotheses aggregation").
struct AgglomerateOptions {
  /// τ: largest ‖q₁ − q₂‖₁ of unit coefficients in coordinates of the region.
  double max_difference = 0.4;
  /// Largest d_close and d_far of one cluster.
  double max_close = 0.4, max_far = 0.3;
};

/// Computes d_far(Q₁, Q₂): the share of the samples that are not inliers of both quadrics, 0 to 1.
/// The paper takes all points of the scene, which makes any two small surfaces far apart; pass the
/// samples of the two surfaces instead.
double far_distance(const Quadric& a, const Quadric& b, const SurfaceSamples& samples,
                    std::span<const int> region, const InlierTest& test);

/// Clusters candidates greedily: two belong together if their d_close (`close_distance`) or else
/// their d_far is small. Of each cluster, the candidate with the largest region is kept.
std::vector<Candidate> agglomerate(std::vector<Candidate> candidates, const SurfaceSamples& samples,
                                   const InlierTest& test, const AgglomerateOptions& options);

}  // namespace quadrille
