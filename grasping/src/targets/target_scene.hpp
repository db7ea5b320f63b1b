#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "space/collision.hpp"
#include "space/obstacle_map.hpp"
#include "targets/target.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// The detection or box that a collision shape belongs to.
struct ShapeOwner {
  /// Id of the detection or box.
  int id = 0;
  /// Centre and largest size of the owner [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double size = 0.0;
};
ShapeOwner owner_of(const Detection& detection);
ShapeOwner owner_of(const Box& box);

/// The surroundings of all targets. Everything that it refers to must outlive it.
struct Surroundings {
  const OccupancyGrid& space;
  const DepthView& view;
  /// The voxels of that space, including the targets' own.
  const ObstacleMap& map;
  /// The shapes of all detections and boxes, and the owner of each.
  const std::vector<CollisionShape>& shapes;
  const std::vector<ShapeOwner>& owners;
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  /// Distance that a hand reaches from a target's surface [m].
  double reach = 0.0;
};

/// Returns the obstacles for a hand that takes a target as a solid. The target's own voxels are
/// removed; those of its support stay.
CollisionScene solid_scene(const Target& target, const Surroundings& around_it);

/// Returns the obstacles for a hand that takes the target by its wall alone: the vessel's contents
/// and its hidden bottom stay obstacles.
CollisionScene shell_scene(const Target& target, const Surroundings& around_it);

}  // namespace quadrille
