#pragma once

#include <Eigen/Geometry>

#include "samples/sight.hpp"

namespace quadrille {

/// The eye of a view and a place that it looks at, in W [m].
struct Outlook {
  Eigen::Vector3d eye_W = Eigen::Vector3d::Zero();
  /// The place at the median depth along the view's axis.
  Eigen::Vector3d place_W = Eigen::Vector3d::Zero();
};

/// @param sight  what the view saw, in its frame C
Outlook outlook_of(const Sight& sight, const Eigen::Isometry3d& X_WC);

/// Angle between the directions from which two views see the place of the first [rad]; infinite if
/// they look at different places.
double angle_between(const Outlook& a, const Outlook& b);

}  // namespace quadrille
