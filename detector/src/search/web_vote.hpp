#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/oriented_points.hpp"
#include "search/vote.hpp"
#include "search/web.hpp"

namespace quadrille {

/// A place in the three-dimensional space of λ that many lines run through.
struct WebPeak {
  Eigen::Vector3d lambda = Eigen::Vector3d::Zero();
  /// Lines within a cell of the peak.
  double votes = 0.0;
};

/// Voting in the three-dimensional null space that two oriented points leave: each voter votes once
/// for each cell that its line of λ runs through, as in a Hough transform. The lines of the points
/// of one quadric meet at its λ. The counts are smoothed, and each of the highest peaks is moved to
/// the point nearest to the lines that pass it.
///
/// The outermost cells do not count: there, at λ = ∞, all lines end.
/// @param options  `bins` holds three times the cells along each coordinate
/// @return no more than options.peaks, most votes first
std::vector<WebPeak> vote(const Web& web, const OrientedPointsf& voters,
                          const VoteOptions& options);

}  // namespace quadrille
