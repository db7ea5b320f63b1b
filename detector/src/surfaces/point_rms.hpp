#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Root mean square first-order distance of the measured points from the quadric of their cell [m].
/// It is larger than that of the samples, each of which is the mean of many points.
/// @param owner  per finest cell of the pyramid, the index of its quadric; −1 for none
/// @return one value per quadric; NaN if it has too few points
std::vector<double> rms_of_points(const CloudView& cloud, const CellPyramid& pyramid,
                                  const std::vector<int>& owner, std::span<const Quadric> quadrics);

}  // namespace quadrille
