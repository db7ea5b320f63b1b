#pragma once

#include <cstdint>
#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>
#include <string>

#include "process/planner/settings.hpp"

namespace quadrille {

/// One grasp as a message; all in frame C.
grasp_t to_message(const Grasp& grasp);

/// One collision shape as a message.
collision_shape_t to_message(const CollisionShape& shape);

/// What the messages on a cloud are stamped with.
struct Stamp {
  std::int64_t utime = 0;
  std::int32_t seq = 0;
  /// Of the results.
  std::string frame;
  /// Of the request that is answered; 0 if nobody asked.
  std::int64_t request_id = 0;
};

/// The grasps of a plan, stamped with the cloud's utime and seq.
grasps_t make_grasps_message(const Stamp& stamp, const GraspPlan& plan,
                             const PlannerSettings& settings);

/// The collision shapes of a plan, stamped likewise.
collision_shapes_t make_shapes_message(const Stamp& stamp, const GraspPlan& plan);

/// The space of a plan as an OctoMap, stamped likewise; without data if the plan has none (null).
/// @throws std::runtime_error if OctoMap cannot write the tree
occupancy_t make_occupancy_message(const Stamp& stamp, const OccupancyGrid* space);

}  // namespace quadrille
