#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/grow.hpp"

namespace quadrille {

/// d_far(Q₁, Q₂): the share of the samples that are not inliers of both, 0 to 1. The paper takes
/// all points of the scene, by which any two small surfaces are far apart; pass those of either
/// surface.
double far_distance(const Quadric& a, const Quadric& b, const SurfaceSamples& samples,
                    std::span<const int> region, const InlierTest& test);

/// Clusters candidates greedily by d_close (`close_distance`), and those that it leaves apart by
/// d_far; of each cluster the candidate with the largest region stays.
std::vector<Candidate> agglomerate(std::vector<Candidate> candidates, const SurfaceSamples& samples,
                                   const InlierTest& test, const AgglomerateOptions& options);

}  // namespace quadrille
