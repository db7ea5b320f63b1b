#pragma once

#include <Eigen/Geometry>

#include "fit/normalisation.hpp"
#include "fit/oriented_points.hpp"
#include "fit/posed_quadric.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// True if the profiles of a family are straight lines.
inline bool is_straight(Family family) {
  return family == Family::kCylinder || family == Family::kCone;
}

/// The line of regression of points' distances from an axis on their heights along it, in local
/// coordinates.
struct ProfileLine {
  /// Pose whose z axis is the axis.
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  /// Height and radius in the middle of the points, and the slope of the radius.
  double z = 0.0, r = 0.0, slope = 0.0;
};

/// @param points  in local coordinates, at least one
/// @param X_CA    pose whose z axis is the axis, in frame C [m]
ProfileLine profile_line(const OrientedPointsf& points, const Normalisation& local,
                         const Eigen::Isometry3d& X_CA);

/// The cylinder or cone whose profile is a line.
/// @param slope  of a cone, in place of the line's own; it becomes at least 0.01 in size
PosedQuadric straight_quadric(Family family, const ProfileLine& line, double slope);

}  // namespace quadrille
