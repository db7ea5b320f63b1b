#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Where planes stop the end of a box.
struct PlaneStop {
  /// Distance of the nearest plane from the end, along the direction in which the end looks;
  /// infinite if there is none [m].
  double distance = 0.0;
  /// True if that plane is parallel to the end: the box may rest on it.
  bool parallel = false;
};

/// The nearest plane before an end of a box that faces it.
/// @param corners_C  the end's four corners [m]
/// @param out_C      unit direction in which it looks
/// @param slack      a plane may lie so far within the box [m]
PlaneStop stop_at_plane(const std::vector<Eigen::Vector3d>& corners_C, const Eigen::Vector3d& out_C,
                        const std::vector<const Detection*>& planes, double slack);

}  // namespace quadrille
