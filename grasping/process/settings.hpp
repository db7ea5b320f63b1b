#pragma once

#include <string>

#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// What the command line asks of the process.
struct PlannerSettings {
  /// Empty: LCM_DEFAULT_URL, or LCM's default.
  std::string lcm_url;
  std::string cloud_channel = "POINT_CLOUD";
  std::string quadrics_channel = "QUADRICS";
  std::string grasps_channel = "GRASPS";
  std::string shapes_channel = "COLLISION_SHAPES";
  std::string occupancy_channel = "OCCUPANCY";
  std::string status_channel = "QUADRILLE_PLANNER_STATUS";
  /// Log to replay instead of the bus, and log that then takes what is published.
  std::string in_log, out_log;
  /// Copy all events of the replayed log to the other one.
  bool copy_input = false;
  bool verbose = false;
  Gripper gripper;
  PlanOptions plan;
};

}  // namespace quadrille
