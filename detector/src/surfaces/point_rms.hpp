#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Root mean square first-order distance of the measured points from the quadric that their cell
/// lies on [m]. Of the samples it is smaller: each is the mean of many points.
/// @param owner  per finest cell of the pyramid, index of its quadric; −1 for none
/// @return one per quadric; NaN where too few points tell
std::vector<double> rms_of_points(const CloudView& cloud, const CellPyramid& pyramid,
                                  const std::vector<int>& owner, std::span<const Quadric> quadrics);

}  // namespace quadrille
