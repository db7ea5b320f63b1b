#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille::experiments {

/// A cylinder that is known to be there.
struct KnownCylinder {
  /// Middle of the axis and unit direction in frame C.
  Eigen::Vector3d centre_C, axis_C;
  double radius;
};

/// Tolerances within which a found cylinder matches a known one.
struct CylinderTolerance {
  /// Angle between the axes [rad].
  double angle = 0.0873;
  /// Distance of the true middle from the found axis, and error of the radius, in true radii.
  double offset = 0.2, radius = 0.1;
};

/// Tells for each known cylinder whether a detection agrees in axis and radius; each detection
/// counts for one cylinder only.
std::vector<char> found_cylinders(const DetectionResult& result,
                                  const std::vector<KnownCylinder>& known,
                                  const CylinderTolerance& tolerance = {});

}  // namespace quadrille::experiments
