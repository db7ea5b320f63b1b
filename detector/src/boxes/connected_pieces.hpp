#pragma once

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// Returns for each place in a plane the number of its connected piece, counted from 0. Places are
/// connected if they share a grid cell or lie in touching cells.
/// @param cell  edge of the cells, in the unit of the places
std::vector<int> connected_pieces(const std::vector<Eigen::Vector2d>& places, double cell);

}  // namespace quadrille
