#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "quadrille/detector/stage_options.hpp"
#include "samples/region.hpp"
#include "samples/surface_samples.hpp"
#include "search/grow.hpp"

namespace quadrille {

/// d_close(Q₁, Q₂) = ‖Q₁ Q₂⁺ − Q₂ Q₂⁺‖ (Frobenius), and infinity where ‖q₁ − q₂‖₁ ≥ τ.
///
/// Printed are the unit matrix for Q₂ Q₂⁺, which for the singular matrices of cones, cylinders and
/// planes would leave a distance of one or more between equal ones, and a product with the
/// indicator of ‖q₁ − q₂‖₁ < τ, which would make the most different quadrics coincide.
/// @param a, b  symmetric 4x4 matrices in one frame, best normalised to the unit ball; their
///              scales and signs do not count
double close_distance(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b, double tau);

/// d_far(Q₁, Q₂): the share of the samples that are not inliers of both, 0 to 1. The paper takes
/// all points of the scene, by which any two small surfaces are far apart; pass those of either
/// surface.
double far_distance(const Quadric& a, const Quadric& b, const SurfaceSamples& samples,
                    std::span<const int> region, const InlierTest& test);

/// Clusters candidates by d_close, and those that it leaves apart by d_far; of each cluster the
/// candidate with the largest region stays.
std::vector<Candidate> agglomerate(std::vector<Candidate> candidates, const SurfaceSamples& samples,
                                   const InlierTest& test, const AgglomerateOptions& options);

}  // namespace quadrille
