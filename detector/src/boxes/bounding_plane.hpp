#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The plane that stops the end of a box from moving outward.
struct PlaneStop {
  /// Distance from the end to the nearest plane along the end's outward direction [m]; infinite if
  /// there is none.
  double distance = 0.0;
  /// True if that plane is parallel to the end, so that the box may rest on it.
  bool parallel = false;
};

/// Finds the nearest plane that faces an end of a box.
/// @param corners_C  the end's four corners [m]
/// @param out_C      unit outward direction of the end
/// @param slack      how far within the box a plane may lie [m]
PlaneStop stop_at_plane(const std::vector<Eigen::Vector3d>& corners_C, const Eigen::Vector3d& out_C,
                        const std::vector<const Detection*>& planes, double slack);

}  // namespace quadrille
