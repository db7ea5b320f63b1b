#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::physics {

/// Turns a true quadric into a detection without error, as if all of it were seen from outside.
/// @param Q_C  quadric in the camera's frame, of either sign
/// @param X_CS  pose of the quadric's own frame S, with z along its axis
/// @param box_S  extent of the surface [m]
Detection exact_quadric(int id, const Quadric& Q_C, const Eigen::Isometry3d& X_CS,
                        const Eigen::AlignedBox3d& box_S);

/// Turns a true plane, z = 0 of its own frame, into a detection without error, seen from the origin
/// of C.
Detection exact_plane(int id, const Eigen::Isometry3d& X_CS, const Eigen::AlignedBox3d& box_S);

}  // namespace quadrille::physics
