#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/robot_shapes.hpp"

namespace octomap {
class OcTree;
}

namespace quadrille {

/// A plane n·p = offset on which things stand; no hand goes below it.
struct KnownSupport {
  /// Unit normal, upwards.
  Eigen::Vector3d n_C = Eigen::Vector3d::UnitZ();
  /// [m]
  double offset = 0.0;
};

/// A map of the scene from elsewhere.
struct KnownMap {
  /// Occupied nodes are obstacles. Free nodes are free where no view tells otherwise. Null: no map.
  std::shared_ptr<const octomap::OcTree> tree;
  /// Pose of the map's frame M in C.
  Eigen::Isometry3d X_CM = Eigen::Isometry3d::Identity();
};

/// Knowledge of a scene that one cloud does not show, in that cloud's frame C.
struct Surroundings {
  /// More views of the same scene at rest, each with its own viewpoint.
  std::vector<PointCloud> views = {};
  /// Points on the robot are neither targets nor obstacles, in none of the views. They hide what is
  /// behind them. The space of the shapes is free, since the hand is where it is.
  RobotShapes robot = {};
  std::optional<KnownSupport> support = {};
  KnownMap map = {};

  /// @throws std::invalid_argument naming the field that is out of range
  QUADRILLE_EXPORT void check() const;
};

/// Returns where the sensor was for a cloud and then for the further views.
QUADRILLE_EXPORT std::vector<Eigen::Vector3d> viewpoints_of(const PointCloud& cloud,
                                                            const Surroundings& known);

/// Transforms surroundings from frame C into frame F.
QUADRILLE_EXPORT Surroundings moved(Surroundings surroundings, const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
