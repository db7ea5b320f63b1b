#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// Fits two planes as one quadric, (π₁·x)(π₂·x) (paper, figure 2b: a basis of two oriented points
/// and nothing to vote for). Each plane starts as that of one oriented point; of all pairs among up
/// to 24 points, and of each of these with the point that its plane explains worst, the pair with
/// the least summed distance is refitted alternately. The detector's
/// two_planes_rss() is faster: it divides samples by their normals first, and so cannot separate
/// parallel planes.
/// @param points  at least 6
/// @return nullopt if the points are too few or coplanar, or if one plane keeps fewer than 3 points
///   or only such that lie nearly on a line
std::optional<Quadric> fit_two_planes(const OrientedPointsd& points);

}  // namespace quadrille
