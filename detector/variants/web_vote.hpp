#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/vote_histogram.hpp"
#include "variants/web.hpp"

namespace quadrille {

/// A point in the three-dimensional space of λ through or near which many lines run.
struct WebPeak {
  Eigen::Vector3d lambda = Eigen::Vector3d::Zero();
  /// Number of lines within a cell of the peak.
  double votes = 0.0;
};

/// Votes in the three-dimensional null space that two oriented points leave. As in a Hough
/// transform, each voter votes once for each cell that its line of λ crosses; the lines of points
/// on one quadric meet at its λ. The counts are smoothed, and each of the highest peaks is moved to
/// the point nearest to the lines that pass it.
///
/// The outermost cells do not count, since all lines end there at λ = ∞.
/// @param options  `bins` is three times the number of cells along each coordinate
/// @return at most options.peaks peaks, those with most votes first
std::vector<WebPeak> vote(const Web& web, const OrientedPointsf& voters,
                          const VoteOptions& options);

}  // namespace quadrille
