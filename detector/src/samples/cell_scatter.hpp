#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Estimates the covariance of the points within each finest cell about the cell's mean, in frame C
/// [m²]; zero for cells without an owner. Each point that is looked at stands for those that are
/// not, so that the estimate is rough for one cell and right on average over many.
/// @param owner  for each finest cell, its owner; −1 for none
std::vector<Eigen::Matrix3f> scatter_in_cells(const CloudView& cloud, const CellPyramid& pyramid,
                                              std::span<const int> owner);

}  // namespace quadrille
