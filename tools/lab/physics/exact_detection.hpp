#pragma once

#include <Eigen/Geometry>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::physics {

/// A true quadric as a detection without error, all of it seen from outside.
/// @param Q_C    in the camera's frame, of either sign
/// @param X_CS   pose of its own frame S, z the axis
/// @param box_S  what there is of it [m]
Detection exact_quadric(int id, const Quadric& Q_C, const Eigen::Isometry3d& X_CS,
                        const Eigen::AlignedBox3d& box_S);

/// A true plane, z = 0 of its own frame, as a detection without error, seen from the origin of C.
Detection exact_plane(int id, const Eigen::Isometry3d& X_CS, const Eigen::AlignedBox3d& box_S);

}  // namespace quadrille::physics
