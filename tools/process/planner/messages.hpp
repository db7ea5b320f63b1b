#pragma once

#include <lcmtypes/quadrille/collision_shapes_t.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/occupancy_t.hpp>

#include "process/planner/settings.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille {

/// One grasp as a message; all in frame C.
grasp_t to_message(const Grasp& grasp);

/// One collision shape as a message.
collision_shape_t to_message(const CollisionShape& shape);

/// The grasps of a plan, stamped with the cloud's utime, seq and frame.
grasps_t make_grasps_message(const bus::CloudMessage& cloud, const GraspPlan& plan,
                             const PlannerSettings& settings);

/// The collision shapes of a plan, stamped likewise.
collision_shapes_t make_shapes_message(const bus::CloudMessage& cloud, const GraspPlan& plan);

/// The space of a plan as an OctoMap, stamped likewise; without data if the plan has none (null).
/// @throws std::runtime_error if OctoMap cannot write the tree
occupancy_t make_occupancy_message(const bus::CloudMessage& cloud, const OccupancyGrid* space);

}  // namespace quadrille
