#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Estimates the covariance of the points within finest cells about each cell's mean, in frame C
/// [m²]. Each point that is looked at stands for those that are not, so that the estimate is rough
/// for one cell and right on average over many.
/// @param number   for each finest cell, where in the list its covariance belongs; −1 for cells
///                 that are not asked for
/// @param scatter  the list, which is added to
void scatter_in_cells(const CloudView& cloud, const CellPyramid& pyramid,
                      std::span<const int> number, std::vector<Eigen::Matrix3f>* scatter);

}  // namespace quadrille
