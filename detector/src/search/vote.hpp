#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/basis.hpp"
#include "search/vote_histogram.hpp"

namespace quadrille {

/// Votes along the one-dimensional null space of a basis (paper, theorem 3 and "Quantizing λ").
/// Each point x votes for λ = −f₀(x) / z(x)² if the gradient there agrees with its normal. The
/// histogram is smoothed (kernel density estimation), and its highest peaks are returned, highest
/// first.
std::vector<VotePeak> vote(const Pencil& pencil, const OrientedPointsf& voters,
                           const VoteOptions& options);

}  // namespace quadrille
