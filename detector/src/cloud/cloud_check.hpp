#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// Result of the checks on the points alone.
struct CloudCheck {
  /// Selects the points in range; all stages and the other fields here use only those.
  RangeCheck range;
  /// Approximate coordinate-wise median of the points in frame C [m].
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  /// False if no surface can be found in the points.
  bool usable = false;
  /// Reasons why the cloud is not usable or looks wrong.
  std::vector<std::string> warnings;
};

/// Checks that a cloud has enough points in range (see check_range()), that they do not all
/// coincide or lie on a line, and that the coordinates look like metres.
CloudCheck check_cloud(const CloudView& cloud);

}  // namespace quadrille
