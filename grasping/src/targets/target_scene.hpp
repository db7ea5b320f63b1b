#pragma once

#include <cstddef>
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

/// What surrounds the targets. All that it refers to must outlive it.
struct Surroundings {
  const OccupancyGrid& space;
  const DepthView& view;
  /// The voxels of all that space, the targets' own included.
  const ObstacleMap& map;
  /// All detections, the shapes of them, and for each shape the index of its detection.
  const std::vector<Detection>& detections;
  const std::vector<CollisionShape>& shapes;
  const std::vector<std::size_t>& shape_of;
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
