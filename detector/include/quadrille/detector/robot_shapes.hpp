#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/solid_shape.hpp"

namespace quadrille {

/// The robot's own shapes when a cloud was taken: its links, its hand, and what that holds.
struct RobotShapes {
  std::vector<SolidShape> shapes;
  /// A point within this distance of a shape is the robot's, because shapes and poses are a little
  /// wrong [m].
  double padding = 0.01;

  /// Returns the cloud without the robot's points, which become NaN.
  QUADRILLE_EXPORT PointCloud taken_from(PointCloud cloud) const;

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

/// Transforms a robot's shapes from frame C into frame F.
QUADRILLE_EXPORT RobotShapes moved(RobotShapes robot, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
