#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "quadrille/detector/cloud_view.hpp"

namespace quadrille {

/// What a look at the points alone tells.
struct CloudCheck {
  std::size_t finite = 0;
  /// Coordinate-wise median of the points, about; frame C [m].
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  /// False if no surface can be found in the points.
  bool usable = false;
  /// Why not, or what looks wrong.
  std::vector<std::string> warnings;
};

/// Checks that a cloud has enough points that do not all coincide or lie on a line, and that its
/// coordinates look like metres.
CloudCheck check_cloud(const CloudView& cloud);

}  // namespace quadrille
