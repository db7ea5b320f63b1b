#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/basis.hpp"
#include "search/vote_options.hpp"
#include "search/vote_peak.hpp"

namespace quadrille {

/// Local voting along the null space (paper, theorem 3 and "Quantizing λ"): each point x votes for
/// λ = −f₀(x) / z(x)², if there the gradient agrees with its normal; the histogram is
/// smoothed (KDE) and its highest peaks are returned, highest first.
std::vector<VotePeak> vote(const Pencil& pencil, const OrientedPointsf& voters,
                           const VoteOptions& options);

}  // namespace quadrille
