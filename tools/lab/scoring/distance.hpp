#pragma once

#include <vector>

#include "lab/scoring/found.hpp"
#include "lab/scoring/frame.hpp"

namespace quadrille::scoring {

/// Returns the mean distance of the points of a surface from the finding to which it is least [m].
/// The points are first moved onto the true surface, so that their noise does not count. No
/// distance counts more than the size of the surface, as all do if there are no findings.
/// @param points  at least one, in frame C
double least_distance(const TrueSurface& surface, const std::vector<Eigen::Vector3f>& points,
                      const std::vector<Found>& findings);

}  // namespace quadrille::scoring
