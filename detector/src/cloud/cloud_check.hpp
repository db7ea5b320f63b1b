#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"
#include "quadrille/detector/range_check.hpp"

namespace quadrille {

/// What a look at the points alone tells.
struct CloudCheck {
  /// What it keeps is what all stages are to see, and what the rest of this tells of.
  RangeCheck range;
  /// Coordinate-wise median of the points, about; frame C [m].
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  /// False if no surface can be found in the points.
  bool usable = false;
  /// Why not, or what looks wrong.
  std::vector<std::string> warnings;
};

/// Checks that a cloud has enough points in range (see check_range()) that do not all coincide or
/// lie on a line, and that its coordinates look like metres.
CloudCheck check_cloud(const CloudView& cloud);

}  // namespace quadrille
