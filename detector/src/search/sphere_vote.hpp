#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/vote_histogram.hpp"

namespace quadrille {

/// The sphere of signed curvature κ = 1/r that touches an oriented point:
///   f = n·d + κ/2 |d|² with d = x − x₁.
/// The gradient at the point is n, and κ = 0 gives a plane.
Eigen::Matrix4d tangent_sphere(const OrientedPoint& point, double curvature);

/// Votes for the one parameter of a sphere that an oriented point leaves free (paper, figure 2b).
/// Each other point votes for κ = −2 n·d / |d|² if its own normal agrees with that sphere.
/// @param options  `min_height` is the least distance of a voter
/// @return peaks with κ stored as lambda, highest first
std::vector<VotePeak> vote_curvature(const OrientedPoint& basis, const OrientedPointsf& voters,
                                     const VoteOptions& options);

}  // namespace quadrille
