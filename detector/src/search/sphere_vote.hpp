#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/basis.hpp"
#include "search/vote.hpp"

namespace quadrille {

/// The sphere of signed curvature κ = 1/r that touches an oriented point,
/// f = n·d + κ/2 |d|² with d = x − x₁: ∇f = n at the point, and a plane for κ = 0.
Eigen::Matrix4d tangent_sphere(const OrientedPoint& point, double curvature);

/// Voting for the one parameter that an oriented point leaves of a sphere (paper, figure 2b): each
/// other point votes for κ = −2 n·d / |d|², if its own normal is that of the sphere.
/// @param options  `lambda_scale` is the curvature that falls into the middle of a half axis;
///                 `min_height` is the least distance of a voter
/// @return peaks with κ in the place of λ, highest first
std::vector<VotePeak> vote_curvature(const OrientedPoint& basis, const OrientedPointsf& voters,
                                     const VoteOptions& options);

}  // namespace quadrille
