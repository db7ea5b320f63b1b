#pragma once

#include <optional>

#include "fits/oriented_points.hpp"

namespace quadrille {

/// Two planes as one quadric, (π₁·x)(π₂·x) (paper, figure 2b: a basis of two oriented points and
/// nothing to vote for). Each of the two is the plane of an oriented point to start with; of all
/// pairs of up to 24 points the one with the least summed distance is refitted alternately.
/// @param points  6 or more
/// @return nullopt if the points are too few or coplanar, or if one plane is left with fewer than 3
std::optional<Quadric> fit_two_planes(const OrientedPoints& points);

}  // namespace quadrille
