#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/grow.hpp"

namespace quadrille {

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
