#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// Makes the detection of a surface that the caller knows, so that grasps can be planned on it.
///
/// Nothing about it is in doubt: its score is 1, it counts as seen all over, and its dimensions
/// have no deviations. Its id is 0; give it one that no other detection or box has.
/// @param type        a type with a real surface
/// @param X_CQ        pose of its canonical frame Q, see Detection::X_CQ
/// @param dimensions  the dimensions of the type by name, see Detection::dimensions [m, rad]
/// @param extent_Q    the part of the quadric that the surface is, in frame Q [m]. If empty, it
///   follows from the dimensions of a sphere, an ellipsoid, a cylinder of either kind, or a plane;
///   other types need it.
/// @param inside      whether it shows its inside to the sensor, as the wall of a bowl does
/// @throws std::invalid_argument naming what is missing, superfluous or out of range
QUADRILLE_EXPORT Detection known_detection(QuadricType type, const Eigen::Isometry3d& X_CQ,
                                           const std::map<std::string, double>& dimensions,
                                           const Eigen::AlignedBox3d& extent_Q = {},
                                           bool inside = false);

/// Makes a box that the caller knows, likewise with the id 0.
/// @param X_CB  pose of the box's frame B, with the origin at its middle
/// @param size  sides along x, y, z of B [m]
/// @throws std::invalid_argument if a side is not positive, or the pose no rotation and translation
QUADRILLE_EXPORT Box known_box(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& size);

/// Returns a pose that a caller gave.
/// @param name  of the pose in errors
/// @throws std::invalid_argument naming it if it is no rotation and translation, to 1e-6
QUADRILLE_EXPORT Eigen::Isometry3d checked_pose(const Eigen::Isometry3d& X,
                                                const std::string& name);

}  // namespace quadrille
