#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "cli/process_arguments.hpp"
#include "process/runtime/poses/cloud_frames.hpp"
#include "process/runtime/poses/view_camera.hpp"
#include "process/runtime/viewer.hpp"
#include "quadrille/detector/options.hpp"
#include "quadrille/detector/tracker.hpp"
#include "quadrille/grasping/grasp_query.hpp"
#include "quadrille/grasping/gripper.hpp"
#include "quadrille/grasping/plan.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille {

/// The settings of the process, from its command line.
struct PlannerSettings {
  ProcessArguments process;
  std::string cloud_channel = "POINT_CLOUD";
  std::string quadrics_channel = "QUADRICS";
  std::string boxes_channel = "BOXES";
  std::string bodies_channel = "BODIES";
  std::string body_tracks_channel = "BODY_TRACKS";
  std::string grasps_channel = "GRASPS";
  std::string request_channel = "GRASP_REQUEST";
  std::string obstacles_channel = "OBSTACLES";
  std::string map_channel = "MAP";
  std::string support_channel = "SUPPORT";
  std::string robot_channel = "ROBOT";
  std::string forget_channel = "FORGET";
  std::string shapes_channel = "COLLISION_SHAPES";
  std::string occupancy_channel = "OCCUPANCY";
  std::string status_channel = "QUADRILLE_PLANNER_STATUS";
  /// Channel of the camera's poses; empty if there are none.
  std::string pose_channel;
  /// Pose of a camera at rest in W; nullopt if it is not known.
  std::optional<Eigen::Isometry3d> X_WK;
  /// Longest time between a cloud and each of the two poses around it, and longest time that a
  /// cloud waits for the later pose [s].
  double pose_age = TrackOptions{}.pose_age, pose_wait = TrackOptions{}.pose_wait;
  CloudFrames frames;
  /// Further cameras that look at the scene.
  std::vector<ViewCamera> view_cameras;
  /// Whether collision shapes and occupancy are published.
  bool shapes = true, occupancy = true;
  /// Least time between published occupancy maps on the bus; 0 to publish one with each plan [s].
  double occupancy_period = 0.0;
  /// Whether messages for the viewer are published, and the channels. They belong to a different
  /// scene of Meldis than the detector's, because a load message resets its whole scene.
  bool viz = false;
  ViewerChannels viewer = {"DRAKE_VIEWER_LOAD_ROBOT_ILLUSTRATION",
                           "DRAKE_VIEWER_DRAW_ILLUSTRATION"};
  /// Plans only on request.
  bool on_request = false;
  Gripper gripper;
  /// The directions of approach, and in `plan` the reach, hold for each plan unless a request names
  /// others. They are in the fixed frame W of the camera's poses, or, if there are none, in the
  /// camera's frame.
  std::optional<Cone> approach;
  /// Shapes that the hand must not touch, and what else is known, for each plan, in the same frame.
  std::vector<CollisionShape> obstacles;
  Surroundings known;
  /// What is fixed to the hand, in its frame G.
  std::vector<CollisionShape> attached;
  /// How views are found and aligned, which are remembered while the camera moves.
  DetectorOptions detector;
  PlanOptions plan;

  /// Returns true if the camera's pose in W is given, or comes on a channel.
  bool has_fixed_frame() const { return X_WK || !pose_channel.empty(); }

  /// Returns true if what other clouds showed serves later plans.
  bool remembers() const {
    const bool others = !pose_channel.empty() || !view_cameras.empty();
    return others && detector.views.remember > 0.0;
  }

  /// Lists each channel: the direction of its messages, the option that names it, its name, and its
  /// content.
  template <class Settings, class Visit>
  static void visit_channels(Settings& settings, const Visit& visit) {
    visit(Way::kIn, "--cloud-channel", settings.cloud_channel, "clouds");
    visit(Way::kIn, "--quadrics-channel", settings.quadrics_channel, "quadrics");
    visit(Way::kIn, "--boxes-channel", settings.boxes_channel, "boxes, sent before their quadrics");
    visit(Way::kIn, "--bodies-channel", settings.bodies_channel,
          "bodies, sent before their quadrics");
    visit(Way::kIn, "--body-tracks-channel", settings.body_tracks_channel,
          "tracks of bodies, sent before their quadrics");
    visit(Way::kOut, "--grasps-channel", settings.grasps_channel, "grasps");
    visit(Way::kIn, "--request-channel", settings.request_channel,
          "requests (quadrille.grasp_request_t)");
    visit(Way::kIn, "--obstacles-channel", settings.obstacles_channel,
          "obstacles (quadrille.collision_shapes_t), each message in place of the one before");
    visit(Way::kIn, "--map-channel", settings.map_channel,
          "maps of the scene from elsewhere (quadrille.occupancy_t), each in place of the one "
          "before");
    visit(Way::kIn, "--support-channel", settings.support_channel,
          "the plane on which things stand (quadrille.support_t)");
    visit(Way::kIn, "--robot-channel", settings.robot_channel,
          "the robot's own shapes (quadrille.robot_t)");
    visit(Way::kIn, "--forget-channel", settings.forget_channel,
          "what to forget of earlier clouds (quadrille.forget_t)");
    visit(Way::kOut, "--shapes-channel", settings.shapes_channel, "collision shapes");
    visit(Way::kOut, "--occupancy-channel", settings.occupancy_channel, "occupancy");
    visit(Way::kOut, "--status-channel", settings.status_channel, "status");
    visit(Way::kIn, "--pose-channel", settings.pose_channel,
          "camera's poses (bot_core.pose_t) in a fixed frame");
    visit_view_cameras(settings.view_cameras, visit);
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
