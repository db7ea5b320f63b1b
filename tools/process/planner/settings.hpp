#pragma once

#include <string>

#include "cli/process_arguments.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// What the command line asks of the process.
struct PlannerSettings {
  ProcessArguments process;
  std::string cloud_channel = "POINT_CLOUD";
  std::string quadrics_channel = "QUADRICS";
  std::string grasps_channel = "GRASPS";
  std::string shapes_channel = "COLLISION_SHAPES";
  std::string occupancy_channel = "OCCUPANCY";
  std::string status_channel = "QUADRILLE_PLANNER_STATUS";
  Gripper gripper;
  PlanOptions plan;
};

}  // namespace quadrille
