#pragma once

#include <Eigen/Core>
#include <vector>

#include "quadrille/detector/box.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/grasping/collision_shape.hpp"
#include "quadrille/grasping/occupancy.hpp"
#include "quadrille/grasping/plan_options.hpp"
#include "space/collision.hpp"
#include "space/obstacle_map.hpp"
#include "targets/target.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// What a collision shape belongs to.
struct ShapeOwner {
  /// Of the detection or box.
  int id = 0;
  /// Its middle, and its largest size [m].
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  double size = 0.0;
};
ShapeOwner owner_of(const Detection& detection);
ShapeOwner owner_of(const Box& box);

/// What surrounds the targets. All that it refers to must outlive it.
struct Surroundings {
  const OccupancyGrid& space;
  const DepthView& view;
  /// The voxels of all that space, the targets' own included.
  const ObstacleMap& map;
  /// The shapes of all detections and boxes, and for each its owner.
  const std::vector<CollisionShape>& shapes;
  const std::vector<ShapeOwner>& owners;
  UnknownPolicy unknown = UnknownPolicy::kObstacle;
  /// How far a hand reaches from a target's surface [m].
  double reach = 0.0;
};

/// What a hand may run into that takes a target as a solid. The target's own voxels give way; those
/// of what it stands on stay.
CollisionScene solid_scene(const Target& target, const Surroundings& around_it);

/// The same for a hand that takes the target by its wall alone: what the vessel holds, and its
/// hidden bottom, stay in the way.
CollisionScene shell_scene(const Target& target, const Surroundings& around_it);

}  // namespace quadrille
