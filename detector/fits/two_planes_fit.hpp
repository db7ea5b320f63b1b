#pragma once

#include <optional>

#include "fits/normalise.hpp"

namespace quadrille {

/// Two planes as one quadric, (π₁·x)(π₂·x) (paper, figure 2b: a basis of two oriented points and
/// nothing to vote for). Each of the two is the plane of an oriented point to start with; of all
/// pairs of up to 24 points the one with the least summed distance is refitted alternately. Not the
/// detector's two_planes_rss(), which parts samples by their normals first, for speed, and so
/// cannot part parallel planes.
/// @param points  6 or more
/// @return nullopt if the points are too few or coplanar, or if one plane is left with fewer than 3
std::optional<Quadric> fit_two_planes(const OrientedPointsd& points);

}  // namespace quadrille
