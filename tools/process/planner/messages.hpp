#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <string>

#include "process/planner/settings.hpp"

namespace quadrille {

/// Converts a grasp to a message; everything is in frame C.
grasp_t to_message(const Grasp& grasp);

/// Converts a collision shape to a message.
collision_shape_t to_message(const CollisionShape& shape);

/// The stamp of the messages about a cloud.
struct Stamp {
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  /// Frame of the results.
  std::string frame;
  /// Id of the answered request; 0 if there was none.
  std::int64_t request_id = 0;
};

/// Makes a message of the grasps of a plan, stamped with the cloud's utime and seq.
grasps_t make_grasps_message(const Stamp& stamp, const GraspPlan& plan,
                             const PlannerSettings& settings);

/// Makes a message of the collision shapes of a plan, with the same stamp.
collision_shapes_t make_shapes_message(const Stamp& stamp, const GraspPlan& plan);

/// Makes a message of the space of a plan as an OctoMap, with the same stamp; without data if the
/// plan has none (null).
/// @throws std::runtime_error if OctoMap cannot write the tree
occupancy_t make_occupancy_message(const Stamp& stamp, const OccupancyGrid* space);

}  // namespace quadrille
