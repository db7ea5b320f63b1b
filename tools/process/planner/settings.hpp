#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "cli/process_arguments.hpp"
#include "process/runtime/cloud_frame.hpp"
#include "process/runtime/viewer.hpp"
#include "quadrille/detector/tracker.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// What the command line asks of the process.
struct PlannerSettings {
  ProcessArguments process;
  std::string cloud_channel = "POINT_CLOUD";
  std::string quadrics_channel = "QUADRICS";
  std::string grasps_channel = "GRASPS";
  std::string request_channel = "GRASP_REQUEST";
  std::string shapes_channel = "COLLISION_SHAPES";
  std::string occupancy_channel = "OCCUPANCY";
  std::string status_channel = "QUADRILLE_PLANNER_STATUS";
  /// Carries the camera's poses; empty for none.
  std::string pose_channel;
  /// The pose of a camera at rest in W; none: not known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Longest time between a cloud and each of the poses about it, and how long a cloud waits for
  /// the later one [s].
  double pose_age = TrackOptions{}.pose_age, pose_wait = TrackOptions{}.pose_wait;
  CloudFrames frames;
  /// Whether collision shapes and occupancy are published.
  bool shapes = true, occupancy = true;
  /// On the bus, occupancy is published at most this often; 0: with each plan [s].
  double occupancy_period = 0.0;
  /// Whether the viewer's messages are published, and on which channels: another scene of Meldis
  /// than the detector's, for a load message resets all of its scene.
  bool viz = false;
  ViewerChannels viewer = {"DRAKE_VIEWER_LOAD_ROBOT_ILLUSTRATION",
                           "DRAKE_VIEWER_DRAW_ILLUSTRATION"};
  /// Plan only what is asked for.
  bool on_request = false;
  Gripper gripper;
  PlanOptions plan;

  /// Lists each channel: which way its messages go, the option that names it, its name, and what
  /// it carries.
  template <class Settings, class Visit>
  static void visit_channels(Settings& settings, const Visit& visit) {
    visit(Way::kIn, "--cloud-channel", settings.cloud_channel, "clouds");
    visit(Way::kIn, "--quadrics-channel", settings.quadrics_channel, "quadrics");
    visit(Way::kOut, "--grasps-channel", settings.grasps_channel, "grasps");
    visit(Way::kIn, "--request-channel", settings.request_channel,
          "requests (quadrille.grasp_request_t)");
    visit(Way::kOut, "--shapes-channel", settings.shapes_channel, "collision shapes");
    visit(Way::kOut, "--occupancy-channel", settings.occupancy_channel, "occupancy");
    visit(Way::kOut, "--status-channel", settings.status_channel, "status");
    visit(Way::kIn, "--pose-channel", settings.pose_channel,
          "camera's poses (bot_core.pose_t) in a fixed frame");
  }

  /// Lists the channels of the viewer, if there is one.
  template <class Settings, class Visit>
  static void visit_viewer(Settings& settings, const Visit& visit) {
    if (!settings.viz) return;
    visit(settings.viewer.load);
    visit(settings.viewer.draw);
  }
};

}  // namespace quadrille
