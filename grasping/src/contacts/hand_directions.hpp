#pragma once

#include <Eigen/Core>
#include <vector>

#include "contacts/candidates.hpp"

namespace quadrille {

/// Returns orientations R_CG of a hand (y closing, z approach) that are worth trying on points of
/// which no shape is known. It closes along the main directions of the normals, across the line of
/// sight, along the axes of the box around the points, and in level directions every 15°. It
/// approaches from every 30° around these that is reachable() and wanted().
/// @param normals_C  unit normals of the target
std::vector<Eigen::Matrix3d> hand_directions(std::vector<Eigen::Vector3d> normals_C,
                                             const ApproachSpace& space);

}  // namespace quadrille
