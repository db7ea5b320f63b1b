#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// For each place in a plane the number of its connected piece, from 0: places in one cell of a
/// grid, or in cells that touch, are connected.
/// @param cell  edge of the cells, in the unit of the places
std::vector<int> connected_pieces(const std::vector<Eigen::Vector2d>& places, double cell);

}  // namespace quadrille
